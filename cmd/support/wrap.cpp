// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/wrap.hpp"

#include <algorithm>
#include <charconv>
#include <cstdlib>
#include <cstring>

#include <sys/ioctl.h>
#include <unistd.h>

namespace wm3d::cmd {

namespace {

/// How the lines of one broken line begin and end.
struct Layout {
    std::size_t first = 0;         ///< indent of the first line
    std::size_t rest = 0;          ///< of all others
    std::string_view joint = "\n"; ///< between lines
};

std::size_t indent_of(std::string_view line) {
    return std::min(line.find_first_not_of(' '), line.size());
}

/// The next word; what a command has between quotes is one word.
std::string_view first_word(std::string_view text, bool command) {
    std::size_t end = std::min(text.find(' '), text.size());
    while (command && end < text.size() && std::ranges::count(text.substr(0, end), '\'') % 2 != 0)
        end = std::min(text.find(' ', end + 1), text.size());
    return text.substr(0, end);
}

/// Appends the words of `text` as lines of at most `width` characters, without a last line end. The first
/// word is appended where `out` stands, at the column layout.first.
void fill(std::string& out, std::string_view text, std::size_t width, const Layout& layout) {
    const std::size_t room = layout.joint.size() - 1; // what marks a line that goes on
    std::size_t column = layout.first;
    bool begun = false;
    while (!text.empty()) {
        const std::string_view word = first_word(text, room > 0);
        text.remove_prefix(std::min(word.size() + 1, text.size()));
        if (word.empty())
            continue;
        if (begun && column + 1 + word.size() + (text.empty() ? 0 : room) > width) {
            out.append(layout.joint).append(layout.rest, ' ');
            column = layout.rest;
        } else if (begun) {
            out += ' ';
            ++column;
        }
        out += word;
        column += word.size();
        begun = true;
    }
}

/// A line that begins with blanks and is too long: an option or command with its description, or a list.
void wrap_indented(std::string& out, std::string_view line, std::size_t width, std::size_t column) {
    const std::size_t indent = indent_of(line);
    const bool described = line.size() > column && line[column - 1] == ' ' && line[column] != ' ';
    const std::size_t start = described ? std::max(column, indent) : indent;
    out.append(line.substr(0, start));
    fill(out, line.substr(start), width, {start, described ? column : indent + 2});
}

/// Consecutive lines without an indent.
void wrap_paragraph(std::string& out, std::string_view lines, std::size_t width) {
    std::string joined(lines);
    std::ranges::replace(joined, '\n', ' ');
    fill(out, joined, width, {});
}

bool fits(std::string_view lines, std::size_t width) {
    for (; !lines.empty(); lines.remove_prefix(std::min(lines.find('\n'), lines.size() - 1) + 1))
        if (std::min(lines.find('\n'), lines.size()) > width)
            return false;
    return true;
}

/// The next line of `text`, or all lines of the paragraph that begins there.
std::string_view next_block(std::string_view text) {
    const auto line_end = [&](std::size_t from) { return std::min(text.find('\n', from), text.size()); };
    std::size_t end = line_end(0);
    if (end == 0 || text[0] == ' ')
        return text.substr(0, end);
    while (end + 1 < text.size() && text[end + 1] != ' ' && text[end + 1] != '\n')
        end = line_end(end + 1);
    return text.substr(0, end);
}

} // namespace

std::size_t help_width() {
    if (::isatty(STDOUT_FILENO) != 1)
        return widest_help;
    std::size_t width = 0;
    if (const char* columns = std::getenv("COLUMNS"))
        std::from_chars(columns, columns + std::strlen(columns), width);
    struct winsize size {};
    if (width == 0 && ::ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0)
        width = size.ws_col;
    return width == 0 ? widest_help : std::clamp(width, narrowest_help, widest_help);
}

std::size_t help_column(std::size_t width) {
    return std::min<std::size_t>(32, width * 2 / 5);
}

std::string wrapped(std::string_view text, std::size_t width, std::size_t column) {
    std::string out;
    bool examples = false;
    while (!text.empty()) {
        const std::string_view block = next_block(text);
        text.remove_prefix(block.size());
        const std::size_t indent = indent_of(block);
        examples = indent == 0 && !block.empty() ? block.starts_with("Example") : examples;
        if (fits(block, width)) {
            out += block;
        } else if (indent == 0) {
            wrap_paragraph(out, block, width);
        } else if (examples) {
            out.append(indent, ' ');
            fill(out, block.substr(indent), width, {indent, indent + 4, " \\\n"});
        } else {
            wrap_indented(out, block, width, column);
        }
        if (!text.empty()) {
            out += '\n';
            text.remove_prefix(1);
        }
    }
    return out;
}

} // namespace wm3d::cmd
