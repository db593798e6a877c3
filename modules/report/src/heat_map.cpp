// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/report/heat_map.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "gnuplot_text.hpp"

namespace wm3d::report {

namespace {

// Everything below is in points.
constexpr double letter = 7.3, row_height = 19, group_gap = 16, margin = 12;
constexpr double top = 76, bottom = 40; // of title and headings, of the legend

/// Blues from light to dark, of evenly falling lightness; the alarm is an orange that the colour-blind tell
/// from them.
constexpr std::array<std::array<double, 3>, 3> shades{{{226, 238, 247}, {94, 160, 204}, {8, 56, 110}}};
constexpr const char* alarm_colour = "#F28E2B";

std::string colour_of(const HeatCell& cell) {
    if (cell.alarm)
        return alarm_colour;
    const double at = std::clamp(cell.shade, 0.0, 1.0) * (shades.size() - 1);
    const auto low = std::min(static_cast<std::size_t>(at), shades.size() - 2);
    const double part = at - static_cast<double>(low);
    std::array<int, 3> rgb{};
    for (std::size_t k = 0; k < 3; ++k)
        rgb[k] = static_cast<int>(std::lround((1 - part) * shades[low][k] + part * shades[low + 1][k]));
    return fmt::format("#{:02X}{:02X}{:02X}", rgb[0], rgb[1], rgb[2]);
}

std::size_t longest(const std::vector<std::string>& texts) {
    std::size_t length = 0;
    for (const std::string& text : texts)
        length = std::max(length, text.size());
    return length;
}

/// All cells are as wide as the longest name of a column, or the longest value, needs.
double cell_width(const HeatMap& map) {
    std::size_t length = 6;
    for (const HeatGroup& group : map.groups) {
        length = std::max(length, longest(group.columns));
        for (const auto& row : group.cells)
            for (const HeatCell& cell : row)
                length = std::max(length, cell.text.size());
    }
    return letter * static_cast<double>(length) + 10;
}

/// A group is as wide as its cells or its heading.
double group_width(const HeatMap& map, const HeatGroup& group) {
    return std::max(cell_width(map) * static_cast<double>(group.columns.size()),
                    letter * static_cast<double>(group.heading.size()));
}

double rows_width(const HeatMap& map) {
    return letter * static_cast<double>(longest(map.rows)) + 2 * margin;
}

std::string label(const std::string& text, double x, double y, const std::string& how) {
    return fmt::format("set label {} at {:.1f},{:.1f} {} noenhanced\n", quoted(text), x, y, how);
}

std::string draw_cell(const HeatCell& cell, double x, double y, double width) {
    if (cell.empty)
        return cell.text.empty()
                   ? ""
                   : label(cell.text, x + width / 2, y + row_height / 2, "center textcolor rgb '#808080'");
    std::string script =
        fmt::format("set object rectangle from {:.1f},{:.1f} to {:.1f},{:.1f} fillcolor rgb '{}' "
                    "fillstyle solid border lc rgb '#FFFFFF'\n",
                    x, y, x + width, y + row_height, colour_of(cell));
    const char* ink = !cell.alarm && cell.shade > 0.65 ? "#FFFFFF" : "#000000";
    return script + label(cell.text, x + width / 2, y + row_height / 2,
                          fmt::format("center front textcolor rgb '{}'", ink));
}

std::string draw_group(const HeatMap& map, const HeatGroup& group, double left) {
    const double width = cell_width(map), whole = group_width(map, group);
    std::string script = label(group.heading, left + whole / 2, top - 34, "center");
    left += (whole - width * static_cast<double>(group.columns.size())) / 2;
    for (std::size_t c = 0; c < group.columns.size(); ++c) {
        const double x = left + width * static_cast<double>(c);
        script += label(group.columns[c], x + width / 2, top - 12, "center");
        for (std::size_t r = 0; r < map.rows.size(); ++r)
            script += draw_cell(group.cells[r][c], x, top + row_height * static_cast<double>(r), width);
    }
    return script;
}

} // namespace

HeatSize heat_map_size(const HeatMap& map) {
    double width = rows_width(map) + margin;
    for (const HeatGroup& group : map.groups)
        width += group_width(map, group) + group_gap;
    const double words =
        letter * static_cast<double>(std::max(map.title.size(), map.legend.size())) + 2 * margin;
    return {static_cast<int>(std::ceil(std::max(width, words))),
            static_cast<int>(std::ceil(top + bottom + row_height * static_cast<double>(map.rows.size())))};
}

std::string gnuplot_script(const HeatMap& map, const std::string& terminal) {
    const HeatSize size = heat_map_size(map);
    std::string script =
        fmt::format("set terminal {}\nset encoding utf8\nunset border\nunset tics\nunset key\n"
                    "set lmargin 0\nset rmargin 0\nset tmargin 0\nset bmargin 0\n"
                    "set xrange [0:{}]\nset yrange [{}:0]\n",
                    terminal, size.width, size.height);
    script += label(map.title, margin, 18, "left");
    for (std::size_t r = 0; r < map.rows.size(); ++r)
        script += label(map.rows[r], rows_width(map) - margin,
                        top + row_height * (static_cast<double>(r) + 0.5), "right");
    double left = rows_width(map);
    for (const HeatGroup& group : map.groups) {
        script += draw_group(map, group, left);
        left += group_width(map, group) + group_gap;
    }
    script += label(map.legend, margin, size.height - 16, "left");
    return script + "plot NaN\n";
}

} // namespace wm3d::report
