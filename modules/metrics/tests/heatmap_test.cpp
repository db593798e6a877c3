// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/metrics/heatmap.hpp>

#include <cmath>

#include <doctest/doctest.h>

using namespace wm3d::metrics;

TEST_CASE("colours run from dark violet to yellow with rising lightness") {
    CHECK(heat_colour(0) == Rgb{68, 1, 84});
    CHECK(heat_colour(1) == Rgb{253, 231, 37});
    CHECK(heat_colour(-3) == heat_colour(0));
    CHECK(heat_colour(7) == heat_colour(1));
    CHECK(heat_colour(NAN) == heat_colour(0));
    double last = 0;
    for (int i = 0; i <= 100; ++i) {
        const Rgb c = heat_colour(i / 100.0);
        const double lightness = 0.2126 * c[0] + 0.7152 * c[1] + 0.0722 * c[2];
        CHECK(lightness > last);
        last = lightness;
    }
}

TEST_CASE("values are scaled to the largest, or to a given top") {
    const double values[] = {0, 1, 2};
    CHECK(heat_colours(values) == std::vector<Rgb>{heat_colour(0), heat_colour(0.5), heat_colour(1)});
    CHECK(heat_colours(values, 4)[2] == heat_colour(0.5));
    const double zeros[] = {0, 0};
    CHECK(heat_colours(zeros)[1] == heat_colour(0));
}
