// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/progress_line.hpp"

#include <cmath>
#include <limits>

#include <doctest/doctest.h>

using wm3d::cmd::progress_text;
using wm3d::cmd::time_left;

TEST_CASE("a wide terminal gets stage, bar and percentage") {
    CHECK(progress_text("simplify", 0.5, 79) == "simplify [############            ]  50 %");
    CHECK(progress_text("simplify", 0.0, 79) == "simplify [                        ]   0 %");
    CHECK(progress_text("simplify", 1.0, 79) == "simplify [########################] 100 %");
}

TEST_CASE("the text fits in any width") {
    for (std::size_t width = 0; width < 60; ++width)
        CHECK(progress_text("a stage with a name of some length", 0.25, width).size() <= width);
    CHECK(progress_text("simplify", 0.25, 20) == "simplify  25 %");
    CHECK(progress_text("simplify", 0.25, 10) == "simp  25 %");
    CHECK(progress_text("simplify", 0.25, 5) == " 25 %");
    CHECK(progress_text("simplify", 0.25, 4).empty());
}

TEST_CASE("the percentage stays between 0 and 100 and is never rounded up to done") {
    CHECK(progress_text("x", -3, 8) == "x   0 %");
    CHECK(progress_text("x", 7, 8) == "x 100 %");
    CHECK(progress_text("x", 0.999, 8) == "x  99 %");
    CHECK(progress_text("x", std::numeric_limits<double>::quiet_NaN(), 8) == "x   0 %");
}

TEST_CASE("the time left is told once it can be told") {
    CHECK(time_left(1, 0.5).empty());
    CHECK(time_left(10, 0.01).empty());
    CHECK(time_left(10, 1).empty());
    CHECK(time_left(10, 0.2) == ", 40 s left");
    CHECK(time_left(60, 0.1) == ", 9 min left");
    CHECK(time_left(std::nan(""), 0.5).empty());
}
