// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/detect/verdict.hpp>

#include <doctest/doctest.h>

using namespace wm3d::detect;

TEST_CASE("present beats everything, absent needs power") {
    CHECK(decide(-7, -6, 0.9) == Verdict::present);
    CHECK(decide(-6, -6, 0.9) == Verdict::present);
    CHECK(decide(-5.9, -6, 0.001) == Verdict::absent);
    CHECK(decide(-5.9, -6, 0.2) == Verdict::inconclusive);
    CHECK(name(Verdict::present) == "present");
    CHECK(name(Verdict::absent) == "absent");
    CHECK(name(Verdict::inconclusive) == "inconclusive");
}

TEST_CASE("the predicted miss is one half where the expected score is just what is needed") {
    CHECK(predicted_miss(4.753424, -6, 1) == doctest::Approx(0.5).epsilon(1e-5));
    CHECK(predicted_miss(30, -6, 48) < 1e-100);
    CHECK(predicted_miss(0, -6, 1) == doctest::Approx(1).epsilon(1e-5));
    CHECK(predicted_miss(5, -6, 100) > predicted_miss(5, -6, 1));
}
