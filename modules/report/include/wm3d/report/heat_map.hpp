// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  A heat map: a grid of coloured cells with their values, as data and as a script for gnuplot.
#pragma once

#include <string>
#include <vector>

namespace wm3d::report {

struct HeatCell {
    std::string text;   ///< in the cell; may be empty
    double shade = 0;   ///< 0 lightest to 1 darkest
    bool alarm = false; ///< stands out from every shade
    bool empty = true;  ///< nothing was measured: no colour
};

/// Columns side by side under one heading; groups stand apart.
struct HeatGroup {
    std::string heading;
    std::vector<std::string> columns;
    std::vector<std::vector<HeatCell>> cells; ///< #rows by #columns
};

struct HeatMap {
    std::string title;
    std::string legend; ///< a line below, that says what the colours mean
    std::vector<std::string> rows;
    std::vector<HeatGroup> groups;
};

/// Width and height that give every cell room for its text, in points.
struct HeatSize {
    int width = 0;
    int height = 0;
};
HeatSize heat_map_size(const HeatMap& map);

/// The commands that draw `map` for a terminal of gnuplot whose canvas has the proportions of
/// `heat_map_size`.
/// \pre  a row and a column at least
std::string gnuplot_script(const HeatMap& map, const std::string& terminal);

} // namespace wm3d::report
