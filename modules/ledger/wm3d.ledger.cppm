// SPDX-License-Identifier: GPL-3.0-or-later
// Written by scripts/interface-units from the public headers, which say what everything is.
module;
#include <wm3d/ledger.hpp>

export module wm3d.ledger;

export namespace wm3d::ledger {
using wm3d::ledger::Addition;
using wm3d::ledger::CheckReport;
using wm3d::ledger::Entry;
using wm3d::ledger::Ledger;
using wm3d::ledger::OpenOptions;
using wm3d::ledger::Owner;
using wm3d::ledger::to_json_line;
using wm3d::ledger::WorkReceipt;
} // namespace wm3d::ledger
