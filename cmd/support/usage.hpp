// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  What the command lines of all commands have in common.
#pragma once

#include <limits>
#include <string>

#include "support/output.hpp"

namespace CLI {
class App;
class Validator;
} // namespace CLI

namespace wm3d::cmd {

/// Adds --json (if the command has a result to tell), -q, -v and --threads to `app`.
void add_output_options(CLI::App& app, OutputOptions& options);

/// Accepts finite numbers of [low, high]; unlike CLI11's own range it refuses "nan".
CLI::Validator number_between(double low, double high);

/// Accepts finite numbers above zero.
CLI::Validator positive_number();

/// Accepts numbers above 0 and below 1.
CLI::Validator probability();

} // namespace wm3d::cmd
