// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include "command.hpp"

namespace wm3d::cmd {

Action declare_ledger(CLI::App& app);

} // namespace wm3d::cmd
