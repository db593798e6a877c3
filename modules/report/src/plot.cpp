// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/report/plot.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <fmt/format.h>

#include "gnuplot_text.hpp"

namespace wm3d::report {

namespace {

/// Colours that people who don't see all of them still tell apart (after Okabe and Ito), dark enough for
/// paper.
constexpr std::array palette{"#0072B2", "#D55E00", "#009E73", "#B1508A", "#8C6D00", "#3E8FC4", "#000000"};
static_assert(palette.size() == palette_size);

constexpr std::array dashes{"1", "'-'", "'_.'", "'.'", "'-..'"};
constexpr std::array shapes{7, 5, 9, 13, 11}; // filled circle, square, triangle, diamond, triangle down

bool fits_log_axes(const PlotPoint& p) {
    return std::isfinite(p.x) && std::isfinite(p.y) && p.x > 0 && p.y > 0;
}

bool has_intervals(const Curve& curve) {
    return std::ranges::any_of(curve.points, [](const PlotPoint& p) { return p.low.has_value(); });
}

std::string data_block(std::size_t number, const Curve& curve, double floor) {
    std::string text = fmt::format("$curve{} << EOD\n", number);
    for (const PlotPoint& p : curve.points) {
        const bool only_interval =
            p.high && *p.high > 0 && !(p.y > 0); // nothing was missed: the upper end says it
        if (fits_log_axes(p) || only_interval)
            text += fmt::format("{:.17g} {:.17g} {:.17g} {:.17g}\n", p.x,
                                std::max(p.y, only_interval ? floor : 0.0),
                                std::max(p.low.value_or(p.y), floor), p.high.value_or(p.y));
    }
    return text + "EOD\n";
}

std::string plot_item(std::size_t number, const Curve& curve) {
    const auto colour = palette[static_cast<std::size_t>(curve.colour) % palette.size()];
    const std::string source = fmt::format("$curve{} using 1:2", number);
    if (curve.style == Curve::Style::line)
        return fmt::format("{} with lines lw 2.5 lc rgb '{}' dt {} title {}", source, colour,
                           dashes[static_cast<std::size_t>(curve.dash) % dashes.size()], quoted(curve.name));
    const int shape = shapes[static_cast<std::size_t>(curve.dash) % shapes.size()];
    return fmt::format("{}{} lw 1.8 ps 0.9 pt {} lc rgb '{}' title {}", source,
                       has_intervals(curve) ? ":3:4 with yerrorbars" : " with points", shape, colour,
                       quoted(curve.name));
}

/// Lowest power of ten that all of the curves need, not below the plot's floor.
double lowest(const Plot& plot) {
    double low = 0.1;
    for (const Curve& curve : plot.curves)
        for (const PlotPoint& p : curve.points)
            if (fits_log_axes(p))
                low = std::min(low, std::max(p.y, plot.y_floor));
    return std::pow(10, std::floor(std::log10(low) + 1e-9));
}

} // namespace

std::string gnuplot_script(const Plot& plot, const std::string& terminal) {
    const double floor = lowest(plot);
    std::string script =
        fmt::format("set terminal {}\n"
                    "set encoding utf8\n"
                    "set title {} noenhanced\n"
                    "set xlabel {} noenhanced\n"
                    "set ylabel {} noenhanced\n"
                    "set logscale xy\n"
                    "set format xy '10^{{%T}}'\n"
                    "set tics nomirror scale 0.7,0.001\n"
                    "set ytics nomirror\n"
                    "set border 3 lc rgb '#404040'\n"
                    "set grid xtics ytics lc rgb '#d9d9d9' lt 1 lw 0.6\n"
                    "set yrange [{:g}:1]\n"
                    "set key below left Left reverse noenhanced samplen 3 spacing 1.2 width 2\n",
                    terminal, quoted(plot.title), quoted(plot.x_label), quoted(plot.y_label), floor);
    std::string items;
    for (std::size_t c = 0; c < plot.curves.size(); ++c) {
        script += data_block(c, plot.curves[c], floor);
        if (c > 0)
            items += ", \\\n     ";
        items += plot_item(c, plot.curves[c]);
    }
    return script + "plot " + items + "\n";
}

} // namespace wm3d::report
