// SPDX-License-Identifier: GPL-3.0-or-later
#include "reference/man_page.hpp"

#include <algorithm>
#include <cctype>
#include <sstream>

#include <fmt/format.h>

#include <wm3d/core/version.hpp>

namespace wm3d::cmd::reference {

namespace {

/// `text` with what troff would take for itself made literal. A hyphen typed here is one that a reader may copy.
std::string literal(std::string_view text) {
    std::string out;
    bool line_begins = true;
    for (const char c : text) {
        if (line_begins && (c == '.' || c == '\''))
            out += "\\&";
        line_begins = c == '\n';
        if (c == '-')
            out += "\\-";
        else if (c == '\\')
            out += "\\e";
        else
            out += c;
    }
    return out;
}

std::string upper(std::string text) {
    std::ranges::transform(text, text.begin(),
                           [](unsigned char c) { return static_cast<char>(std::toupper(c)); });
    return text;
}

std::string heading(const std::string& title) {
    return fmt::format(".SH {}\n", literal(upper(title)));
}

std::string bold(std::string_view text) {
    return fmt::format("\\fB{}\\fR", literal(text));
}

std::string italic(std::string_view text) {
    return fmt::format("\\fI{}\\fR", literal(text));
}

std::string title(const std::string& name, std::string_view section_of) {
    return fmt::format(".TH {} 1 \"\" \"wm3d {}\" \"{}\"\n", literal(upper(name)), literal(version()),
                       literal(section_of));
}

/// Lines of prose are filled anew; what is indented stays as it is laid out.
std::string prose(const std::string& text) {
    std::string out;
    bool kept = false;
    std::istringstream lines(text);
    for (std::string line; std::getline(lines, line);) {
        const bool keep = line.starts_with(' ');
        if (keep != kept)
            out += keep ? ".PP\n.nf\n" : ".fi\n.PP\n";
        kept = keep;
        out += line.empty() ? ".PP\n" : literal(line) + "\n";
    }
    return kept ? out + ".fi\n" : out;
}

std::string usage_of(const Option& option) {
    std::string text = bold(option.names.back());
    if (!option.value.empty())
        text += fmt::format(" {}", italic(option.value));
    return text;
}

std::string synopsis(const Page& page) {
    std::string out = fmt::format("{} {}", bold("wm3d"), bold(page.name));
    for (const Option& argument : page.arguments) {
        const std::string place = italic(argument.names.front()) + (argument.repeated ? "..." : "");
        out += argument.required ? fmt::format(" {}", place) : fmt::format(" [{}]", place);
    }
    for (const Option& option : page.options)
        if (option.required)
            out += fmt::format(" {}", usage_of(option));
    return out + fmt::format(" [{}]\n", italic("OPTION") + "...");
}

std::string entry(const Option& option) {
    std::string names;
    for (const std::string& name : option.names)
        names += (names.empty() ? "" : ", ") + (name.starts_with('-') ? bold(name) : italic(name));
    if (!option.value.empty() && option.names.front().starts_with('-'))
        names += fmt::format(" {}", italic(option.value));
    std::string text = literal(option.help);
    if (!option.choices.empty())
        text += fmt::format(":\n{}", literal(fmt::format("{}", fmt::join(option.choices, ", "))));
    if (option.required && option.names.front().starts_with('-'))
        text += "\n(required)";
    return fmt::format(".TP\n{}\n{}\n", names, text);
}

std::string option_sections(const Page& page) {
    std::string out;
    if (!page.arguments.empty()) {
        out += heading("Arguments");
        for (const Option& argument : page.arguments)
            out += entry(argument);
    }
    std::vector<std::string> groups;
    for (const Option& option : page.options)
        if (std::ranges::find(groups, option.group) == groups.end())
            groups.push_back(option.group);
    for (const std::string& group : groups) {
        out += group == "Options" ? heading(group) : heading(group + " options");
        for (const Option& option : page.options)
            if (option.group == group)
                out += entry(option);
    }
    return out;
}

std::string examples(const std::vector<std::string>& lines) {
    if (lines.empty())
        return {};
    std::string out = heading("Examples") + ".nf\n";
    for (const std::string& line : lines)
        out += literal(line) + "\n";
    return out + ".fi\n";
}

} // namespace

std::string man_page(const Page& page) {
    std::string out = title("wm3d-" + page.name, "Commands of wm3d");
    out += heading("Name") + fmt::format("wm3d\\-{} \\- {}\n", literal(page.name), literal(page.summary));
    out += heading("Synopsis") + synopsis(page);
    out += heading("Description") + prose(page.description);
    out += option_sections(page);
    if (!page.notes.empty())
        out += heading("Notes") + prose(page.notes);
    if (page.description.find("Exit status") == std::string::npos)
        out += heading("Exit status") + "0 done, 1 a check of the result failed, 2 error.\n";
    out += examples(page.examples);
    return out + heading("See also") + fmt::format("{}(1)\n", bold("wm3d"));
}

std::string man_overview(std::span<const Command> commands) {
    std::string out = title("wm3d", "Commands of wm3d");
    out += heading("Name") + "wm3d \\- blind watermarks for 3D meshes, with exact probabilities\n";
    out += heading("Synopsis") +
           fmt::format("{} {} [{}...]\n", bold("wm3d"), italic("COMMAND"), italic("OPTION"));
    out +=
        heading("Description") +
        literal(
            "Hides an owner's mark in the geometry of a 3D mesh, and later tells from a copy and the owner's "
            "key alone whether the mark is there.\n");
    std::string_view group;
    for (const Command& command : commands) {
        if (command.group != group)
            out += heading(std::string(group = command.group));
        out += fmt::format(".TP\n{}(1)\n{}\n", bold(fmt::format("wm3d-{}", command.name)),
                           literal(command.summary));
    }
    out += ".PP\nAny other name runs the executable \\fBwm3d\\-\\fINAME\\fR from PATH.\n";
    out += heading("Options");
    for (const Option& option : program_options())
        out += entry(option);
    out += heading("Environment") + ".TP\n\\fBNO_COLOR\\fR\nNo colours, whatever the terminal can do\n";
    out += heading("Exit status") +
           "0 done, 1 a check of the result failed, 2 error. \\fBwm3d\\-verify\\fR(1) has its own.\n";
    return out;
}

} // namespace wm3d::cmd::reference
