// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/description.hpp"

#include <algorithm>
#include <array>

#include <CLI/CLI.hpp>

#include "support/usage.hpp"

namespace wm3d::cmd::reference {

namespace {

/// "FILE" of "FILE (required)"; nothing of "(finds the strength)".
std::string value_name(const std::string& option_text) {
    const std::string word = option_text.substr(0, option_text.find(' '));
    return word.starts_with('(') ? std::string() : word;
}

/// The words of "TEXT:{one,two}", which is how CLI11 tells of a closed list, or of "TEXT:{one->0,two->1}".
std::vector<std::string> choices_of(const CLI::Option& option) {
    const std::string type = option.get_type_name();
    const std::size_t begin = type.find('{'), end = type.find('}', begin);
    if (end == std::string::npos)
        return {};
    std::vector<std::string> words = CLI::detail::split(type.substr(begin + 1, end - begin - 1), ',');
    for (std::string& word : words)
        word.erase(std::min(word.find("->"), word.size()));
    return words;
}

Values values_of(const Option& option) {
    constexpr std::array files{"FILE", "PATH", "PATH...", "MESH"};
    if (!option.choices.empty())
        return Values::one_of;
    if (std::ranges::find(files, option.value) != files.end())
        return Values::file;
    return option.value == "DIR" ? Values::folder : Values::any;
}

Option describe(const CLI::Option& defined) {
    Option option;
    if (defined.nonpositional()) {
        for (const std::string& name : defined.get_snames())
            option.names.push_back("-" + name);
        for (const std::string& name : defined.get_lnames())
            option.names.push_back("--" + name);
    } else {
        option.names.push_back(defined.get_name(true));
    }
    if (defined.get_items_expected_max() > 0) {
        const std::string text = value_name(defined.get_option_text());
        option.value = text.empty() ? "VALUE" : text;
    }
    option.help = defined.get_description();
    option.group = defined.get_group();
    option.choices = choices_of(defined);
    option.values = values_of(option);
    option.required = defined.get_required();
    option.repeated = defined.get_items_expected_max() > 1;
    return option;
}

/// Cuts the examples off the text below the options. A line of an example begins with two spaces.
void split_footer(const std::string& footer, Page& page) {
    std::size_t begin = footer.rfind("\nExample");
    begin = begin != std::string::npos ? begin + 1 : footer.starts_with("Example") ? 0 : footer.size();
    page.notes = footer.substr(0, begin);
    for (const std::string& line : CLI::detail::split(footer.substr(begin), '\n'))
        if (line.starts_with("  "))
            page.examples.push_back(line.substr(2));
}

} // namespace

Page describe(const Command& command) {
    CLI::App app;
    OutputOptions output;
    declare(command, app, output);
    Page page{std::string(command.name), std::string(command.summary), app.get_description(), {}, {}, {}, {}};
    const CLI::App& declared = app;
    for (const CLI::Option* option : declared.get_options())
        if (!option->get_group().empty()) // an empty one hides the option
            (option->nonpositional() ? page.options : page.arguments).push_back(describe(*option));
    split_footer(app.get_footer(), page);
    return page;
}

std::vector<Option> program_options() {
    Option help, version;
    help.names = {"-h", "--help"};
    help.help = "Print the list of commands and exit";
    version.names = {"-V", "--version"};
    version.help = "Print the version and exit";
    return {help, version};
}

} // namespace wm3d::cmd::reference
