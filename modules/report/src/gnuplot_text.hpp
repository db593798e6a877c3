// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Text in scripts for gnuplot.
#pragma once

#include <string>

namespace wm3d::report {

/// A string of gnuplot without any escapes: a quote is doubled.
inline std::string quoted(const std::string& text) {
    std::string result = "'";
    for (char c : text)
        result.append(c == '\'' ? 2 : 1, c == '\n' ? ' ' : c);
    return result + "'";
}

} // namespace wm3d::report
