// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The registration table: every command of `wm3d`, once.
#pragma once

#include <span>

#include "command.hpp"

namespace wm3d::cmd {

/// All commands, in the order in which the help lists them.
std::span<const Command> commands();

/// The command called `name`, or null.
const Command* find_command(std::string_view name);

} // namespace wm3d::cmd
