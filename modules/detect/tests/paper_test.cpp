// SPDX-License-Identifier: GPL-3.0-or-later
#include <cmath>
#include <limits>

#include <doctest/doctest.h>

#include <wm3d/core/error.hpp>
#include <wm3d/detect/paper.hpp>
#include <wm3d/detect/paper_null.hpp>

using namespace wm3d;
using namespace wm3d::detect;

TEST_CASE("P_m at the strength where threshold and mean meet is one half") {
    const double pf = 1e-6, sigma_r = 0.18, mean_square = 0.0033;
    const std::size_t n = 2500;
    const double meeting = threshold(pf, n, sigma_r * sigma_r, mean_square, 0, 0) / mean_square;
    CHECK(miss_probability(meeting, n, mean_square, sigma_r, pf) == doctest::Approx(0.5).epsilon(1e-12));
    CHECK(miss_probability(0, n, mean_square, sigma_r, pf) == doctest::Approx(1 - pf).epsilon(1e-12));
}

TEST_CASE("log10 P_m goes on where P_m underflows") {
    const double p = miss_probability(1.0, 10000, 0.0033, 0.18, 1e-6);
    CHECK(log10_miss_probability(1.0, 10000, 0.0033, 0.18, 1e-6) ==
          doctest::Approx(std::log10(p)).epsilon(1e-12));
    const double deep = log10_miss_probability(20.0, 10000, 0.0033, 0.18, 1e-6);
    CHECK(deep < -80000);
    CHECK(std::isfinite(deep));
    CHECK(miss_probability(20.0, 10000, 0.0033, 0.18, 1e-6) == 0);
    // The two formulas meet at the switch: neighbours on both sides differ smoothly.
    const auto at = [](double gamma) { return log10_miss_probability(gamma, 10000, 0.0033, 0.18, 1e-6); };
    const double gamma = (100 + 3.3612) * std::sqrt(2.0) * 0.18 / std::sqrt(33.0);
    const double slope_left = at(gamma - 0.02) - at(gamma - 0.04),
                 slope_right = at(gamma + 0.04) - at(gamma + 0.02);
    const double step = at(gamma + 0.02) - at(gamma - 0.02);
    CHECK(step == doctest::Approx(slope_left + slope_right).epsilon(1e-5));
}

TEST_CASE("statistics of radii and bumps") {
    const std::vector<double> radius{1, 2, 3}, delta{0.1, -0.1, 0.3};
    const PaperStatistics s = paper_statistics(radius, delta);
    CHECK(s.n == 3);
    CHECK(s.rho == doctest::Approx((0.1 - 0.2 + 0.9) / 3));
    CHECK(s.mu_r == doctest::Approx(2));
    CHECK(s.sigma_r2 == doctest::Approx(2.0 / 3));
    CHECK(s.delta_mean == doctest::Approx(0.1));
    CHECK(s.delta_mean_square == doctest::Approx(0.11 / 3));
}

TEST_CASE("parameters out of range are refused in one sentence") {
    const double nan = std::numeric_limits<double>::quiet_NaN();
    for (double pf : {0.0, 1.0, -1e-6, nan}) {
        CHECK_THROWS_AS(miss_probability(1, 10, 0.1, 0.1, pf), ParameterError);
        CHECK_THROWS_AS(threshold(pf, 10, 0.1, 0.1, 0, 0), ParameterError);
    }
    CHECK_THROWS_AS(miss_probability(1, 0, 0.1, 0.1, 0.1), ParameterError);
    CHECK_THROWS_AS(miss_probability(1, 10, -0.1, 0.1, 0.1), ParameterError);
    CHECK_THROWS_AS(miss_probability(1, 10, 0.1, 0, 0.1), ParameterError);
    CHECK_THROWS_AS(threshold(0.1, 10, -1, 0.1, 0, 0), ParameterError);
    CHECK_THROWS_AS(correlation({}, {}), ParameterError);
}

TEST_CASE("the linear statistic is the correlation less its mean part") {
    sphere::SparseRows rows;
    rows.columns = 4;
    rows.indices = {{0, 1, 2}, {1, 2, 3}, {3, 0, 1}};
    rows.weights = {{0.2, 0.3, 0.5}, {1, 0, 0}, {0.25, 0.5, 0.25}};
    const std::vector<double> radius{0.8, 1.1, 1.3}, w{0.05, -0.02, 0.09, -0.1};
    const std::vector<double> delta = sphere::multiply(rows, w);
    const PaperStatistics s = paper_statistics(radius, delta);
    const LinearStatistic t = paper_statistic(radius, rows, 0.1);
    CHECK(t.value(w) == doctest::Approx(s.rho - s.mu_r * s.delta_mean).epsilon(1e-12));
}
