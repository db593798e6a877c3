// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  From the arguments of the process to its exit status.
#pragma once

#include <span>

namespace wm3d::cmd {

/// Finds the command that arguments[1] names, parses the rest, runs it and turns every exception into one
/// sentence on standard error. A name that is no command runs `wm3d-NAME` from PATH in place of this process.
/// \return the exit status
int run_program(std::span<char* const> arguments);

} // namespace wm3d::cmd
