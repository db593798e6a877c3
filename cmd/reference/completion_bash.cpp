// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/completion.hpp"

#include <fmt/format.h>

namespace wm3d::cmd::reference {

namespace {

constexpr std::string_view head = R"sh(# Completion of wm3d for bash; needs nothing but bash itself.

_wm3d_files() {
    compopt -o filenames 2>/dev/null
    mapfile -t COMPREPLY < <(compgen "$1" -- "$2")
}

# The value of option $2 of command $1, begun as $3; status 1 if that option takes none.
_wm3d_value() {
    case $1:$2 in
)sh";

constexpr std::string_view middle = R"sh(        *) return 1 ;;
    esac
}

# Options of command $1.
_wm3d_options() {
    case $1 in
)sh";

constexpr std::string_view tail = R"sh(    esac
}

_wm3d() {
    local current=${COMP_WORDS[COMP_CWORD]} command=${COMP_WORDS[1]:-} option=
    COMPREPLY=()
    # Without the separator "=" of COMP_WORDBREAKS, --option=value is one word.
    if [[ $current == = ]]; then
        option=${COMP_WORDS[COMP_CWORD - 1]} current=
    elif [[ $COMP_CWORD -gt 2 && ${COMP_WORDS[COMP_CWORD - 1]} == = ]]; then
        option=${COMP_WORDS[COMP_CWORD - 2]}
    elif [[ $COMP_CWORD -gt 1 ]]; then
        option=${COMP_WORDS[COMP_CWORD - 1]}
    fi
    if [[ $COMP_CWORD -eq 1 || $command == help ]]; then
        local words
        words=$(_wm3d_options '')
        words+=$(compgen -c wm3d- | sed 's/^wm3d-/ /' | sort -u)
        mapfile -t COMPREPLY < <(compgen -W "$words" -- "$current")
    elif [[ $option == -* ]] && _wm3d_value "$command" "$option" "$current"; then
        return
    elif [[ $current == -* ]]; then
        mapfile -t COMPREPLY < <(compgen -W "$(_wm3d_options "$command")" -- "$current")
    else
        _wm3d_files -f "$current"
    fi
}

complete -F _wm3d wm3d
)sh";

std::string pattern_of(const Page& page, const Option& option) {
    std::string pattern;
    for (const std::string& name : option.names)
        pattern += fmt::format("{}{}:{}", pattern.empty() ? "" : " | ", page.name, name);
    return pattern;
}

std::string reply_of(const Option& option) {
    switch (option.values) {
    case Values::file:
        return "_wm3d_files -f \"$3\"";
    case Values::folder:
        return "_wm3d_files -d \"$3\"";
    case Values::one_of:
        return fmt::format("mapfile -t COMPREPLY < <(compgen -W '{}' -- \"$3\")",
                           fmt::join(option.choices, " "));
    case Values::any:
        break;
    }
    return ":"; // a number or a name: nothing to offer
}

} // namespace

std::string bash_completion(std::span<const Page> pages) {
    std::string out(head);
    for (const Page& page : pages)
        for (const Option& option : page.options)
            if (!option.value.empty())
                out += fmt::format("        {}) {} ;;\n", pattern_of(page, option), reply_of(option));
    out += middle;
    std::string commands = "help";
    for (const Page& page : pages)
        commands += " " + page.name;
    for (const Option& option : program_options())
        commands += fmt::format(" {}", fmt::join(option.names, " "));
    out += fmt::format("        '') echo '{}' ;;\n", commands);
    for (const Page& page : pages) {
        std::string names;
        for (const Option& option : page.options)
            names += fmt::format("{}{}", names.empty() ? "" : " ", fmt::join(option.names, " "));
        out += fmt::format("        {}) echo '{}' ;;\n", page.name, names);
    }
    return out += tail;
}

} // namespace wm3d::cmd::reference
