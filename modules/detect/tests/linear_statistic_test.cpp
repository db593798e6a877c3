// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/detect/linear_statistic.hpp>

#include <cmath>

#include <doctest/doctest.h>

using namespace wm3d::detect;

TEST_CASE("value, spread and maximum of a small sum") {
    const LinearStatistic t({3, -4}, 0.5);
    const std::vector<double> w{0.5, -0.25};
    CHECK(t.value(w) == doctest::Approx(2.5));
    CHECK(t.sigma() == doctest::Approx(0.5 * std::sqrt(25.0 / 3)));
    CHECK(t.maximum() == doctest::Approx(3.5));
}

TEST_CASE("the cumulants are those of uniform numbers") {
    const LinearStatistic t({3, -4}, 0.5);
    for (double s : {1e-6, 0.01, 0.06, 0.07, 0.5, 3.0, 40.0}) {
        const double a = 1.5 * s, b = 2.0 * s;
        const Cumulants k = cumulants(t, s);
        const double small = std::min(a, b) < 0.05 ? 1e-9 : 1e-13; // log(sinh x / x) itself cancels
        CHECK(k.k0 ==
              doctest::Approx(std::log(std::sinh(a) / a) + std::log(std::sinh(b) / b)).epsilon(small));
    }
    CHECK(cumulants(t, 0).k2 == doctest::Approx(t.sigma() * t.sigma()).epsilon(1e-14));
}

TEST_CASE("the derivatives agree with differences, on both sides of the switch to the series") {
    const LinearStatistic t({1.0}, 1.0);
    for (double s : {0.02, 0.0999999, 0.1000001, 1.0, 5.0, 30.0}) {
        const double h = 1e-4;
        const Cumulants low = cumulants(t, s - h), mid = cumulants(t, s), high = cumulants(t, s + h);
        CHECK(mid.k1 == doctest::Approx((high.k0 - low.k0) / (2 * h)).epsilon(1e-6));
        CHECK(mid.k2 == doctest::Approx((high.k1 - low.k1) / (2 * h)).epsilon(1e-6));
    }
    const Cumulants below = cumulants(t, 0.1 * (1 - 1e-12)), above = cumulants(t, 0.1 * (1 + 1e-12));
    CHECK(below.k0 == doctest::Approx(above.k0).epsilon(1e-11));
    CHECK(below.k1 == doctest::Approx(above.k1).epsilon(1e-11));
    CHECK(below.k2 == doctest::Approx(above.k2).epsilon(1e-11));
}

TEST_CASE("the cumulants of signs") {
    const LinearStatistic t({3, -4}, 0.5, Law::sign);
    CHECK(t.sigma() == doctest::Approx(0.5 * 5));
    for (double s : {1e-6, 4e-5, 1e-4, 0.5, 3.0, 40.0}) {
        const Cumulants k = cumulants(t, s);
        const double a = 1.5 * s, b = 2.0 * s;
        const double small = b < 0.01 ? 1e-7 : 1e-13; // log cosh itself cancels
        CHECK(k.k0 == doctest::Approx(std::log(std::cosh(a)) + std::log(std::cosh(b))).epsilon(small));
        CHECK(k.k1 == doctest::Approx(1.5 * std::tanh(a) + 2 * std::tanh(b)).epsilon(1e-13));
        CHECK(
            k.k2 ==
            doctest::Approx(std::pow(1.5 / std::cosh(a), 2) + std::pow(2 / std::cosh(b), 2)).epsilon(1e-12));
    }
}

TEST_CASE("large arguments don't overflow") {
    const LinearStatistic t({1.0, 1e-3}, 1.0);
    const Cumulants k = cumulants(t, 1e6);
    CHECK(std::isfinite(k.k0));
    CHECK(k.k1 < t.maximum());
    CHECK(k.k2 > 0);
}
