// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/usage.hpp"

#include <cmath>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

namespace wm3d::cmd {

namespace {

/// The number that all of `text` spells, or NaN.
double parse_number(const std::string& text) {
    double value = 0;
    return CLI::detail::lexical_cast(text, value) ? value : std::nan("");
}

} // namespace

void add_output_options(CLI::App& app, OutputOptions& options) {
    app.add_flag("--json", options.json, "Print the result as one JSON object")->group("Output");
    app.add_flag("-q,--quiet", options.quiet, "Say nothing but errors and the result")->group("Output");
    app.add_flag("-v,--verbose", options.verbose, "Say what happens on the way")->group("Output");
    app.add_option("--threads", options.threads, "Threads to use; the result is the same with any number")
        ->option_text("N")
        ->check(number_between(1, 4096))
        ->group("Output");
}

CLI::Validator number_between(double low, double high) {
    return CLI::Validator(
        [low, high](std::string& text) {
            const double value = parse_number(text);
            return value >= low && value <= high
                       ? std::string()
                       : fmt::format("'{}' is not a number from {} to {}", text, low, high);
        },
        fmt::format("{} to {}", low, high));
}

CLI::Validator positive_number() {
    return CLI::Validator(
        [](std::string& text) {
            const double value = parse_number(text);
            return std::isfinite(value) && value > 0 ? std::string()
                                                     : fmt::format("'{}' is not a number above 0", text);
        },
        "above 0");
}

CLI::Validator probability() {
    return CLI::Validator(
        [](std::string& text) {
            const double value = parse_number(text);
            return value > 0 && value < 1
                       ? std::string()
                       : fmt::format("'{}' is not a probability between 0 and 1, such as 1e-6", text);
        },
        "between 0 and 1");
}

} // namespace wm3d::cmd
