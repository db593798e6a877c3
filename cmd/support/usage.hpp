// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  What the command lines of all commands have in common.
#pragma once

#include <cstddef>
#include <cstdint>
#include <string>

#include "command.hpp"
#include "support/output.hpp"

namespace CLI {
class App;
class ParseError;
class Validator;
} // namespace CLI

namespace wm3d::cmd {

/// Declares all of a command: its own options, then --json, -q, -v, --threads and --help, so that the help lists
/// those last.
/// \return what to do once they are parsed
Action declare(const Command& command, CLI::App& app, OutputOptions& options);

/// The help of a command, in lines of at most `width` characters.
std::string help_text(CLI::App& app, std::size_t width);

/// What is wrong with a command line, as one sentence that says what would mend it.
std::string usage_complaint(const CLI::App& app, const CLI::ParseError& error);

/// Accepts whole numbers of [low, high].
CLI::Validator whole_number_between(std::uint64_t low, std::uint64_t high);

/// Accepts finite numbers of [low, high]; unlike CLI11's own range it refuses "nan".
CLI::Validator number_between(double low, double high);

/// Accepts finite numbers above zero.
CLI::Validator positive_number();

/// Accepts numbers above 0 and up to 1.
CLI::Validator share();

/// Accepts numbers above 0 and below 1.
CLI::Validator probability();

} // namespace wm3d::cmd
