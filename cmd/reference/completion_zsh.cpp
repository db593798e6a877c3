// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/completion.hpp"

#include <fmt/format.h>

namespace wm3d::cmd::reference {

namespace {

/// For the inside of single quotes, and of a field that ends at a colon or a bracket.
std::string field(std::string_view text) {
    std::string out;
    for (const char c : text) {
        if (c == '\'')
            out += "'\\''";
        else if (c == ':' || c == '[' || c == ']' || c == '\\')
            out += std::string("\\") + c;
        else
            out += c;
    }
    return out;
}

std::string action_of(const Option& option) {
    switch (option.values) {
    case Values::file:
        return "_files";
    case Values::folder:
        return "_files -/";
    case Values::one_of:
        return fmt::format("({})", fmt::join(option.choices, " "));
    case Values::any:
        break;
    }
    return {};
}

/// One specification for _arguments. Of two names of an option each rules out the other.
std::string option_specification(const Option& option) {
    std::string out;
    if (option.names.size() > 1)
        out += fmt::format("'({0})'{{{1}}}", fmt::join(option.names, " "), fmt::join(option.names, ","));
    else
        out += option.repeated ? "'*'" + option.names.front() : option.names.front();
    out += fmt::format("'[{}]", field(option.help));
    if (!option.value.empty())
        out += fmt::format(":{}:{}", field(option.value), action_of(option));
    return out + "'";
}

std::string argument_specification(const Option& argument) {
    return fmt::format("'{}{}:{}:_files'", argument.repeated ? "*" : "", argument.required ? "" : ":",
                       field(argument.names.front()));
}

} // namespace

std::string zsh_completion(std::span<const Page> pages) {
    std::string out =
        "#compdef wm3d\n# Completion of wm3d for zsh.\n\n_wm3d() {\n    local -a commands\n    commands=(\n";
    for (const Page& page : pages)
        out += fmt::format("        '{}:{}'\n", page.name, field(page.summary));
    out += "        'help:explain a command'\n    )\n    if (( CURRENT == 2 )); then\n"
           "        _describe -t commands 'command' commands\n        _arguments";
    for (const Option& option : program_options())
        out.append(" ").append(option_specification(option));
    out += "\n        return\n    fi\n    local command=$words[2]\n    shift words\n    (( CURRENT-- ))\n"
           "    case $command in\n        help) _describe -t commands 'command' commands ;;\n";
    for (const Page& page : pages) {
        out += fmt::format("        {}) _arguments -S", page.name);
        for (const Option& option : page.options)
            out += " \\\n            " + option_specification(option);
        for (const Option& argument : page.arguments)
            out += " \\\n            " + argument_specification(argument);
        out += " ;;\n";
    }
    return out + "        *) _files ;;\n    esac\n}\n\n_wm3d \"$@\"\n";
}

} // namespace wm3d::cmd::reference
