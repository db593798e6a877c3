// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  What a command is.
#pragma once

#include <functional>
#include <string_view>

namespace CLI {
class App;
}

namespace wm3d::cmd {

class Output;

/// Runs a command whose arguments are parsed; returns the exit status.
using Action = std::function<int(Output&)>;

/// A line of the registration table.
struct Command {
    std::string_view name;
    std::string_view group;   ///< heading in the list of commands
    std::string_view summary; ///< half a line for that list

    /// Adds the command's description, options and examples to `app` and returns what to do once they are
    /// parsed. Nothing is opened before that.
    Action (*declare)(CLI::App& app);
};

/// Exit statuses; `verify` has its own meaning for 0, 1 and 3.
enum ExitStatus : int { exit_done = 0, exit_check_failed = 1, exit_error = 2 };

} // namespace wm3d::cmd
