// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  A plot of curves on log-log axes, as data and as a script for gnuplot.
#pragma once

#include <optional>
#include <string>
#include <vector>

namespace wm3d::report {

/// A point, with an interval of y if it was measured.
struct PlotPoint {
    double x = 0;
    double y = 0;
    std::optional<double> low{}, high{}; ///< ends of the interval
};

struct Curve {
    enum class Style { line, points };

    std::string name; ///< in the legend
    Style style = Style::line;
    int colour = 0; ///< which of the palette's; curves of one colour differ by `dash`
    int dash = 0;   ///< which pattern of a line, which shape of points
    std::vector<PlotPoint> points;
};

struct Plot {
    std::string title;
    std::string x_label, y_label;
    std::vector<Curve> curves;
    double y_floor = 1e-30; ///< what lies below is cut off
};

/// How many colours the palette has; curves beyond start anew with it.
inline constexpr int palette_size = 7;

/// The commands and data that draw `plot` for a terminal of gnuplot, such as "svg size 900,600". Points that
/// can't stand on a logarithmic axis (0, negative, not finite) are left out; an interval that reaches below
/// the floor ends there.
std::string gnuplot_script(const Plot& plot, const std::string& terminal);

} // namespace wm3d::report
