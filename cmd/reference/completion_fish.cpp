// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/completion.hpp"

#include <fmt/format.h>

namespace wm3d::cmd::reference {

namespace {

std::string word(std::string_view text) {
    std::string out = "'";
    for (const char c : text) {
        if (c == '\'' || c == '\\')
            out += '\\';
        out += c;
    }
    return out + "'";
}

std::string names_of(const Option& option) {
    std::string out;
    for (const std::string& name : option.names)
        out += name.starts_with("--") ? " -l " + name.substr(2) : " -s " + name.substr(1);
    return out;
}

/// -r: a value is wanted; -F: files are offered for it; -f: no files.
std::string value_of(const Option& option) {
    if (option.value.empty())
        return {};
    switch (option.values) {
    case Values::file:
        return " -r -F";
    case Values::folder:
        return " -x -a '(__fish_complete_directories)'";
    case Values::one_of:
        return fmt::format(" -x -a '{}'", fmt::join(option.choices, " "));
    case Values::any:
        break;
    }
    return " -x";
}

std::string line(std::string_view condition, const Option& option) {
    return fmt::format("complete -c wm3d -n '{}'{}{} -d {}\n", condition, names_of(option), value_of(option),
                       word(option.help));
}

} // namespace

std::string fish_completion(std::span<const Page> pages) {
    std::string out = "# Completion of wm3d for fish.\n\n";
    constexpr std::string_view first = "__fish_use_subcommand";
    for (const Page& page : pages)
        out += fmt::format("complete -c wm3d -n '{}' -f -a {} -d {}\n", first, page.name, word(page.summary));
    out += fmt::format("complete -c wm3d -n '{}' -f -a help -d 'explain a command'\n", first);
    for (const Option& option : program_options())
        out += line(first, option);
    for (const Page& page : pages) {
        out += '\n';
        for (const Option& option : page.options)
            out += line("__fish_seen_subcommand_from " + page.name, option);
    }
    return out;
}

} // namespace wm3d::cmd::reference
