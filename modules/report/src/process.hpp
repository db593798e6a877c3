// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Running another program.
#pragma once

#include <string>
#include <vector>

namespace wm3d::report {

struct ProcessResult {
    bool found = true; ///< the program is on PATH
    bool success = false;
    std::string output; ///< standard output
    std::string errors; ///< standard error
};

/// Runs `arguments` (the first is the program, looked up on PATH) with `input` on standard input.
/// \throw Error  if the system lacks the means
ProcessResult run_process(const std::vector<std::string>& arguments, const std::string& input);

} // namespace wm3d::report
