// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/usage.hpp"

#include <algorithm>
#include <charconv>
#include <cmath>
#include <filesystem>
#include <vector>

#include <CLI/CLI.hpp>
#include <fmt/format.h>

#include "support/suggest.hpp"
#include "support/wrap.hpp"

namespace wm3d::cmd {

namespace {

/// The number that all of `text` spells, or NaN.
double parse_number(const std::string& text) {
    double value = 0;
    return CLI::detail::lexical_cast(text, value) ? value : std::nan("");
}

/// One line, without the full stop that our own sentence brings.
std::string as_clause(std::string text) {
    std::ranges::replace(text, '\n', ' ');
    text.erase(text.find_last_not_of(". ") + 1);
    return text;
}

/// Long names of the options, with their hyphens.
std::vector<std::string> option_names(const CLI::App& app) {
    std::vector<std::string> names;
    for (const CLI::Option* option : app.get_options())
        for (const std::string& name : option->get_lnames())
            names.push_back("--" + name);
    return names;
}

bool looks_like_option(const std::string& word) {
    return word.starts_with('-');
}

/// What is not expected: an option that doesn't exist, or a word too many.
std::string complaint_about_extras(const CLI::App& app) {
    const std::vector<std::string> extras = app.remaining();
    const auto option = std::ranges::find_if(extras, looks_like_option);
    if (option == extras.end())
        return fmt::format("there is nothing that '{}' could mean here",
                           extras.empty() ? "" : extras.front());
    std::error_code ignored;
    if (std::filesystem::exists(*option, ignored))
        return fmt::format("'{0}' is not an option; the file of that name is './{0}'", *option);
    const std::string name = option->substr(0, option->find('='));
    const std::vector<std::string> names = option_names(app);
    const std::vector<std::string_view> views(names.begin(), names.end());
    if (const auto near = nearest_name(name, views))
        return fmt::format("'{}' is not an option; did you mean '{}'", name, *near) + "?";
    return fmt::format("'{}' is not an option", name);
}

void add_output_options(CLI::App& app, OutputOptions& options) {
    // For programs; people are asked, and the error that asks for it names it.
    if (app.get_option_no_throw("--key") != nullptr)
        app.add_option("--passphrase-fd", options.passphrase_fd)
            ->group("")
            ->check(whole_number_between(0, 1 << 20));
    app.add_flag("--json", options.json, "Print the result as one JSON object")->group("Output");
    app.add_flag("-q,--quiet", options.quiet, "Say nothing but errors and the result")->group("Output");
    app.add_flag("-v,--verbose", options.verbose, "Say what happens on the way")->group("Output");
    app.add_option("--threads", options.threads, "Threads to use; the result is the same with any number")
        ->option_text("N")
        ->check(whole_number_between(1, 4096))
        ->group("Output");
    app.set_help_flag("-h,--help", "Print this help and exit")->group("Output");
}

} // namespace

Action declare(const Command& command, CLI::App& app, OutputOptions& options) {
    app.set_help_flag();
    Action action = command.declare(app);
    add_output_options(app, options);
    return action;
}

std::string help_text(CLI::App& app, std::size_t width) {
    const std::size_t column = help_column(width);
    app.get_formatter()->column_width(column);
    std::string text = app.help();
    // CLI11 leaves two empty lines between groups and none above the usage.
    for (std::size_t at; (at = text.find("\n\n\n")) != std::string::npos;)
        text.erase(at, 1);
    if (const std::size_t at = text.find("\nUsage: "); at != std::string::npos)
        text.insert(at, "\n");
    if (!text.ends_with('\n'))
        text += '\n';
    return wrapped(text, width, column);
}

std::string usage_complaint(const CLI::App& app, const CLI::ParseError& error) {
    // What is required may be there, and be taken for an option.
    const bool extras = dynamic_cast<const CLI::ExtrasError*>(&error) != nullptr ||
                        (dynamic_cast<const CLI::RequiredError*>(&error) != nullptr &&
                         std::ranges::any_of(app.remaining(), looks_like_option));
    const std::string clause = extras ? complaint_about_extras(app) : as_clause(error.what());
    return clause.ends_with('?') ? clause : fmt::format("{}; see '{} --help'.", clause, app.get_name());
}

CLI::Validator whole_number_between(std::uint64_t low, std::uint64_t high) {
    return CLI::Validator(
        [low, high](std::string& text) {
            std::uint64_t value = 0;
            const char* end = text.data() + text.size();
            const auto [stop, error] = std::from_chars(text.data(), end, value);
            return error == std::errc() && stop == end && value >= low && value <= high
                       ? std::string()
                       : fmt::format("'{}' is not a whole number from {} to {}", text, low, high);
        },
        "");
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

CLI::Validator share() {
    return CLI::Validator(
        [](std::string& text) {
            const double value = parse_number(text);
            return value > 0 && value <= 1 ? std::string()
                                           : fmt::format("'{}' is not a number above 0 and up to 1", text);
        },
        "above 0, up to 1");
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
