// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  A table of text cells, in the forms that people and programs read.
#pragma once

#include <string>
#include <vector>

namespace wm3d::report {

struct Table {
    std::vector<std::string> columns;           ///< headings
    std::vector<std::vector<std::string>> rows; ///< #rows by #columns
};

/// Columns aligned by blanks, two between them, no blank at the end of a line; numbers to the right.
std::string to_text(const Table& table);

/// RFC 4180 with line feeds: a heading line, quotes where a cell needs them.
std::string to_csv(const Table& table);

/// A table as GitHub reads it.
std::string to_markdown(const Table& table);

} // namespace wm3d::report
