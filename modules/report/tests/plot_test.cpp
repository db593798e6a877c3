// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/report/plot.hpp>

#include <limits>

#include <doctest/doctest.h>

#include "contains.hpp"

using namespace wm3d::report;
using test::contains;

namespace {

Plot plot_of(std::vector<PlotPoint> points, Curve::Style style = Curve::Style::line) {
    Plot plot{"title", "x", "y", {}, 1e-30};
    plot.curves.push_back({.name = "c", .style = style, .points = std::move(points)});
    return plot;
}

} // namespace

TEST_CASE("points that a logarithmic axis can't show are left out") {
    const std::string script = gnuplot_script(
        plot_of({{0.25, 0.5}, {0, 1}, {-1, 1}, {0.5, 0}, {std::numeric_limits<double>::quiet_NaN(), 1}}),
        "svg");
    CHECK(contains(script, "$curve0 << EOD\n0.25 0.5 0.5 0.5\nEOD\n"));
}

TEST_CASE("the axis reaches to the lowest point, but not below the floor") {
    CHECK(contains(gnuplot_script(plot_of({{0.1, 3e-5}}), "svg"), "set yrange [1e-05:1]"));
    CHECK(contains(gnuplot_script(plot_of({{0.1, 1e-200}}), "svg"), "set yrange [1e-30:1]"));
}

TEST_CASE("intervals are drawn, also where nothing was counted") {
    const std::string script = gnuplot_script(
        plot_of({{0.25, 0.5, 0.25, 0.75}, {0.125, 0, 0, 0.0625}}, Curve::Style::points), "svg");
    CHECK(contains(script, "with yerrorbars"));
    CHECK(contains(script, "0.25 0.5 0.25 0.75\n"));
    CHECK(contains(script, "0.125 0.10000000000000001 0.10000000000000001 0.0625\n"));
}

TEST_CASE("quotes and line breaks in a name can't leave its string") {
    Plot plot = plot_of({{0.5, 0.5}});
    plot.curves[0].name = "it's\n`x`";
    CHECK(contains(gnuplot_script(plot, "svg"), "title 'it''s `x`'"));
}
