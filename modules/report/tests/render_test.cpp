// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/report/render.hpp>

#include <doctest/doctest.h>
#include <fmt/format.h>

#include <wm3d/core/error.hpp>

#include "contains.hpp"

using namespace wm3d::report;
using test::contains;

namespace {

Plot example_plot() {
    Plot plot{"ROC", "P_f", "P_m", {}, 1e-30};
    plot.curves.push_back({.name = "predicted", .points = {{1e-6, 1e-2}, {1e-3, 1e-5}}});
    plot.curves.push_back({.name = "measured",
                           .style = Curve::Style::points,
                           .colour = 1,
                           .points = {{1e-4, 1e-3, 1e-4, 1e-2}}});
    return plot;
}

} // namespace

TEST_CASE("a plot without points is refused before any program runs") {
    CHECK_THROWS_AS(render(Plot{}, Image::svg), wm3d::ParameterError);
}

TEST_CASE("gnuplot draws every curve with its name, the labels and the intervals") {
    if (!can_render()) {
        fmt::print("SKIPPED: gnuplot is not installed\n");
        return;
    }
    const std::string svg = render(example_plot(), Image::svg);
    for (const char* part : {"<svg", "predicted", "measured", "P_f", "P_m", "ROC", "</svg>"})
        CHECK_MESSAGE(contains(svg, part), part);
    const std::string png = render(example_plot(), Image::png);
    CHECK(png.starts_with("\x89PNG"));
}

TEST_CASE("gnuplot draws a heat map with every name and value") {
    CHECK_THROWS_AS(render(HeatMap{}, Image::svg), wm3d::ParameterError);
    if (!can_render()) {
        fmt::print("SKIPPED: gnuplot is not installed\n");
        return;
    }
    const HeatMap map{"title",
                      "legend",
                      {"noise", "it's"},
                      {{"group", {"bunny"}, {{{"-12.5", 0.3, false, false}}, {{"-1.5", 0, true, false}}}}}};
    const std::string svg = render(map, Image::svg);
    for (const char* part : {"title", "legend", "noise", "it's", "group", "bunny", "-12.5", "-1.5"})
        CHECK_MESSAGE(contains(svg, part), part);
    CHECK(render(map, Image::png).starts_with("\x89PNG"));
}
