// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/report/render.hpp>

#include <algorithm>

#include <fmt/format.h>

#include <wm3d/mesh/error.hpp>

#include "process.hpp"

namespace wm3d::reporting {

namespace {

const char* terminal_of(Image image) {
    return image == Image::svg ? "svg size 960,600 dynamic enhanced font 'Arial,Helvetica,sans-serif,14' "
                                 "background rgb 'white'"
                               : "pngcairo size 1440,900 enhanced font 'Sans,18' background rgb 'white'";
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

} // namespace

bool can_render() {
    return run_process({"gnuplot", "--version"}, "").success;
}

std::string render(const Plot& plot, Image image) {
    if (!drawable(plot))
        throw ParameterError("there is nothing to plot: no curve has a point above 0");
    const ProcessResult result =
        run_process({"gnuplot", "-d", "-"}, gnuplot_script(plot, terminal_of(image)));
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

} // namespace wm3d::reporting
