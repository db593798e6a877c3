// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/report/table.hpp>

#include <algorithm>

#include <fmt/format.h>

namespace wm3d::report {

namespace {

using Row = std::vector<std::string>;

/// Columns of the screen that UTF-8 text takes: its code points.
std::size_t width(const std::string& text) {
    return static_cast<std::size_t>(std::ranges::count_if(text, [](char c) { return (c & 0xC0) != 0x80; }));
}

bool is_number(const std::string& text) {
    return !text.empty() && (text.front() == '-' || (text.front() >= '0' && text.front() <= '9'));
}

std::vector<std::size_t> column_widths(const Table& table) {
    std::vector<std::size_t> widths;
    for (const std::string& heading : table.columns)
        widths.push_back(width(heading));
    for (const Row& row : table.rows)
        for (std::size_t c = 0; c < row.size() && c < widths.size(); ++c)
            widths[c] = std::max(widths[c], width(row[c]));
    return widths;
}

/// A column is set to the right if every cell of it that isn't empty starts as a number does.
std::vector<bool> numeric_columns(const Table& table) {
    std::vector<bool> numeric(table.columns.size(), true);
    for (const Row& row : table.rows)
        for (std::size_t c = 0; c < row.size() && c < numeric.size(); ++c)
            numeric[c] = numeric[c] && (row[c].empty() || row[c] == "-" || is_number(row[c]));
    return numeric;
}

std::string csv_cell(const std::string& cell) {
    if (cell.find_first_of(",\"\r\n") == std::string::npos)
        return cell;
    std::string quoted = "\"";
    for (char c : cell)
        quoted.append(c == '"' ? 2 : 1, c);
    return quoted + '"';
}

std::string csv_line(const Row& row) {
    std::string line;
    for (std::size_t c = 0; c < row.size(); ++c) {
        if (c > 0)
            line += ',';
        line += csv_cell(row[c]);
    }
    return line + '\n';
}

std::string markdown_line(const Row& row) {
    std::string line = "|";
    for (const std::string& cell : row) {
        line += ' ';
        for (char c : cell) {
            if (c == '|')
                line += '\\';
            line += c;
        }
        line += " |";
    }
    return line + '\n';
}

} // namespace

std::string to_text(const Table& table) {
    const std::vector<std::size_t> widths = column_widths(table);
    const std::vector<bool> right = numeric_columns(table);
    const auto line = [&](const Row& row) {
        std::string text;
        for (std::size_t c = 0; c < row.size(); ++c) {
            const std::string pad(widths[c] - width(row[c]), ' ');
            if (c > 0)
                text += "  ";
            text += right[c] ? pad + row[c] : row[c] + pad;
        }
        text.erase(text.find_last_not_of(' ') + 1);
        return text + '\n';
    };
    std::string text = line(table.columns);
    for (const Row& row : table.rows)
        text += line(row);
    return text;
}

std::string to_csv(const Table& table) {
    std::string text = csv_line(table.columns);
    for (const Row& row : table.rows)
        text += csv_line(row);
    return text;
}

std::string to_markdown(const Table& table) {
    const std::vector<bool> right = numeric_columns(table);
    std::string text = markdown_line(table.columns) + "|";
    for (bool numeric : right)
        text += numeric ? " ---: |" : " --- |";
    text += '\n';
    for (const Row& row : table.rows)
        text += markdown_line(row);
    return text;
}

} // namespace wm3d::report
