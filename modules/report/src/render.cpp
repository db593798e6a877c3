// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/report/render.hpp>

#include <algorithm>

#include <fmt/format.h>

#include <wm3d/core/error.hpp>

#include "process.hpp"

namespace wm3d::report {

namespace {

/// Pictures of points have half as many pixels again, and their letters are as much larger.
std::string terminal_of(Image image, int width, int height, int letters) {
    return image == Image::svg
               ? fmt::format("svg size {},{} dynamic enhanced font 'Arial,Helvetica,sans-serif,{}' "
                             "background rgb 'white'",
                             width, height, letters)
               : fmt::format("pngcairo size {},{} enhanced font 'Sans,{}' background rgb 'white'",
                             width * 3 / 2, height * 3 / 2, (letters * 9 + 3) / 7);
}

bool drawable(const Plot& plot) {
    return std::ranges::any_of(plot.curves, [](const Curve& curve) {
        return std::ranges::any_of(
            curve.points, [](const PlotPoint& p) { return p.x > 0 && (p.y > 0 || p.high.value_or(0) > 0); });
    });
}

std::string first_complaint(const std::string& errors) {
    // gnuplot echoes the line and points at the column; what is wrong comes after "line N: ".
    const std::size_t at = errors.find("line ");
    std::string text = at == std::string::npos ? errors : errors.substr(at);
    return text.substr(0, text.find('\n'));
}

std::string draw(const std::string& script) {
    const ProcessResult result = run_process({"gnuplot", "-d", "-"}, script);
    if (!result.found)
        throw Error("plots are drawn by gnuplot, which isn't installed; install it, for example with "
                    "'apt-get install gnuplot-nox'");
    if (!result.success || result.output.empty())
        throw Error(
            fmt::format("gnuplot could not draw the plot: {}; version 5.2 or newer is needed, with the "
                        "terminals svg and pngcairo",
                        first_complaint(result.errors)));
    return result.output;
}

} // namespace

bool can_render() {
    return run_process({"gnuplot", "--version"}, "").success;
}

std::string render(const Plot& plot, Image image) {
    if (!drawable(plot))
        throw ParameterError("there is nothing to plot: no curve has a point above 0");
    return draw(gnuplot_script(plot, terminal_of(image, 960, 600, 14)));
}

std::string render(const HeatMap& map, Image image) {
    if (map.rows.empty() || map.groups.empty())
        throw ParameterError("there is nothing to plot: the heat map has no cell");
    const HeatSize size = heat_map_size(map);
    return draw(gnuplot_script(map, terminal_of(image, size.width, size.height, 12)));
}

} // namespace wm3d::report
