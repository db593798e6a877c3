// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Help that fits the terminal it is read on.
#pragma once

#include <cstddef>
#include <string>
#include <string_view>

namespace wm3d::cmd {

/// Widest help, also where standard output is no terminal: longer lines are hard to read.
inline constexpr std::size_t widest_help = 100;
inline constexpr std::size_t narrowest_help = 40;

/// Columns for text on standard output: what COLUMNS or the terminal says, within these bounds.
std::size_t help_width();

/// Column of an option's description in help of that width: names that are longer get a line of their own.
std::size_t help_column(std::size_t width);

/// Breaks lines between words so that none has more than `width` characters. Paragraphs that don't fit are
/// filled anew; of a line "  name    description" the rest goes on below the description, at `column`; commands
/// below a line that begins with "Example" stay what a shell understands.
std::string wrapped(std::string_view text, std::size_t width, std::size_t column);

} // namespace wm3d::cmd
