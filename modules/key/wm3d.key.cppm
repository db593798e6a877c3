// SPDX-License-Identifier: GPL-3.0-or-later
// Written by scripts/interface-units from the public headers, which say what everything is.
module;
#include <wm3d/key.hpp>

export module wm3d.key;

export namespace wm3d::key {
using wm3d::key::AskPassphrase;
using wm3d::key::commitment;
using wm3d::key::fingerprint;
using wm3d::key::index_of;
using wm3d::key::Key;
using wm3d::key::max_level;
using wm3d::key::null_secret;
using wm3d::key::Passphrase;
using wm3d::key::ProtectionCost;
using wm3d::key::PublicParameters;
using wm3d::key::Purpose;
using wm3d::key::Secret;
using wm3d::key::sequence_length;
using wm3d::key::Stream;
using wm3d::key::symmetric_unit;
using wm3d::key::watermark_sequence;
} // namespace wm3d::key
