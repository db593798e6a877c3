// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The command line as data, read from the very definitions that parse it.
#pragma once

#include <string>
#include <string_view>
#include <vector>

#include "command.hpp"

namespace wm3d::cmd::reference {

/// What a shell may put where a value is wanted.
enum class Values { any, file, folder, one_of };

/// An option, or an argument without a name.
struct Option {
    std::vector<std::string> names;   ///< "-o", "--output"; of an argument without a name its place, "IN"
    std::string value;                ///< what the help calls the value, "FILE"; empty: a flag
    std::string help;                 ///< the help's own words
    std::string group;                ///< heading in the help
    Values values = Values::any;      ///< what may stand for the value
    std::vector<std::string> choices; ///< the words themselves, for Values::one_of
    bool required = false;
    bool repeated = false; ///< more than one value may follow
};

/// A command as its help tells it.
struct Page {
    std::string name;    ///< "mark"
    std::string summary; ///< half a line
    std::string description;
    std::vector<Option> arguments; ///< in their order
    std::vector<Option> options;   ///< in the order of the help
    std::string notes;             ///< below the options, before the examples; laid out by hand
    std::vector<std::string> examples;
};

Page describe(const Command& command);

/// The program's own flags, which stand in place of a command.
std::vector<Option> program_options();

} // namespace wm3d::cmd::reference
