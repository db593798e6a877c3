// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/detect/tail.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

using namespace wm3d::detect;

namespace {

/// log10 P(T >= t) for a sum of n uniform numbers on (-1, 1), from the Irwin-Hall formula near the upper end,
/// where it is one positive term: (n - t)^n / (2^n n!) for t >= n - 2.
double log10_irwin_hall_end(int n, double t) {
    return (n * std::log((n - t) / 2) - std::lgamma(n + 1)) / std::numbers::ln10;
}

LinearStatistic equal_terms(int n) {
    return {std::vector<double>(static_cast<std::size_t>(n), 1.0), 1.0};
}

/// Coefficients of very different size, as real meshes give.
LinearStatistic uneven_terms() {
    std::vector<double> c;
    for (int j = 1; j <= 3000; ++j)
        c.push_back(std::sin(j * 1.7) * std::exp(-3.0 * ((j * 37) % 100) / 100.0));
    return {std::move(c), 0.1};
}

} // namespace

TEST_CASE("exact tails against the Irwin-Hall formula, down to 1e-27") {
    for (int n : {8, 12, 20})
        for (double above : {1.9, 1.0, 0.5}) {
            const Tail tail = exact_tail(equal_terms(n), n - above);
            const double expected = log10_irwin_hall_end(n, n - above);
            if (tail.bound)
                CHECK(tail.log10_p >= expected);
            else
                CHECK(tail.log10_p == doctest::Approx(expected).epsilon(1e-6));
        }
    CHECK_FALSE(exact_tail(equal_terms(20), 18.1).bound);
}

TEST_CASE("a sum of two is a triangle") {
    // P(T >= t) = (2 - t)^2 / 8
    const Tail tail = exact_tail(equal_terms(2), 0.5);
    const double expected = std::log10(1.5 * 1.5 / 8);
    if (tail.bound)
        CHECK(tail.log10_p >= expected);
    else
        CHECK(tail.log10_p == doctest::Approx(expected).epsilon(1e-5));
}

TEST_CASE("symmetry, the middle and the ends") {
    const LinearStatistic t = uneven_terms();
    CHECK(exact_tail(t, 0).log10_p == doctest::Approx(std::log10(0.5)).epsilon(1e-9));
    for (double z : {0.1, 1.0, 2.5}) {
        const double above = std::pow(10, exact_tail(t, z * t.sigma()).log10_p);
        const double below = std::pow(10, exact_tail(t, -z * t.sigma()).log10_p);
        CHECK(above + below == doctest::Approx(1).epsilon(1e-9));
    }
    CHECK(exact_tail(t, t.maximum() * 1.0001).log10_p < -1e300);
    CHECK(exact_tail(LinearStatistic({0.0}, 1), 0).log10_p == 0);
}

TEST_CASE("saddlepoint and exact tails agree, and Chernoff's bound is above both, to 1e-300 and beyond") {
    const LinearStatistic t = uneven_terms();
    for (double z : {0.01, 0.5, 1.0, 3.0, 5.0, 10.0, 20.0, 36.0}) {
        const Tail exact = exact_tail(t, z * t.sigma());
        REQUIRE_FALSE(exact.bound);
        CHECK(exact.relative_error < 1e-8);
        const double approximate = saddlepoint_log10_tail(t, z * t.sigma());
        CHECK(std::abs(approximate - exact.log10_p) < 1e-3);
        const double bound = chernoff_log10_bound(t, z * t.sigma());
        CHECK(bound >= exact.log10_p);
        CHECK(bound < exact.log10_p + 1 + std::log10(1 + 3 * z)); // about s sigma sqrt(2 pi)
    }
    CHECK(exact_tail(t, 36 * t.sigma()).log10_p < -250);
}

TEST_CASE("near the mean a normal distribution is close, far out it is not") {
    const LinearStatistic t = uneven_terms();
    const auto normal = [](double z) { return std::log10(std::erfc(z / std::numbers::sqrt2) / 2); };
    CHECK(exact_tail(t, 2 * t.sigma()).log10_p == doctest::Approx(normal(2)).epsilon(1e-2));
    // Uniform numbers have light tails.
    CHECK(exact_tail(t, 20 * t.sigma()).log10_p < normal(20));
}

TEST_CASE("the quantile is where the tail has the probability") {
    const LinearStatistic t = uneven_terms();
    for (double log10_pf : {-0.5, -1.0, -6.0, -50.0, -200.0})
        CHECK(saddlepoint_log10_tail(t, tail_quantile(t, log10_pf)) ==
              doctest::Approx(log10_pf).epsilon(1e-8));
}

TEST_CASE("a quantile close to the largest value of few terms is found") {
    for (std::size_t terms : {1, 2, 3, 4, 5, 8}) {
        std::vector<double> c(200, 1e-6);
        std::fill_n(c.begin(), terms, 1.0);
        const LinearStatistic t(c, 0.1);
        for (double log10_pf : {-1.0, -2.0, -4.0, -6.0}) {
            const double quantile = tail_quantile(t, log10_pf);
            CHECK(quantile > 0);
            CHECK(quantile <= t.maximum());
            const double reached =
                saddlepoint_log10_tail(t, quantile); // flat to rounding next to the maximum
            CHECK(reached < log10_pf + 1e-6);
            CHECK(reached > log10_pf - 0.1);
        }
    }
}

TEST_CASE("the tail of a sum of signs is the count of the sign choices that reach it") {
    std::vector<double> c;
    for (int j = 0; j < 20; ++j)
        c.push_back(1 + 0.37 * std::sin(1.0 + 5.3 * j));
    const LinearStatistic t(c, 0.5, Law::sign);
    std::vector<double> values;
    for (unsigned choice = 0; choice < 1u << 20; ++choice) {
        double sum = 0;
        for (unsigned j = 0; j < 20; ++j)
            sum += (choice >> j & 1 ? 0.5 : -0.5) * c[j];
        values.push_back(sum);
    }
    for (double z : {0.5, 1.5, 2.5, 3.2}) {
        const double at = z * t.sigma();
        const auto reached = std::count_if(values.begin(), values.end(), [&](double v) { return v >= at; });
        const double counted = std::log10(static_cast<double>(reached) / static_cast<double>(values.size()));
        const Tail tail = exact_tail(t, at);
        if (tail.bound) // so few signs are still steps
            CHECK(tail.log10_p >= counted);
        else
            CHECK(tail.log10_p == doctest::Approx(counted).epsilon(1e-3));
        CHECK(saddlepoint_log10_tail(t, at) == doctest::Approx(counted).epsilon(2e-2));
    }
}

TEST_CASE("sums of many signs: exact, fast and bounded forms agree") {
    const LinearStatistic uniform = uneven_terms();
    const LinearStatistic t({uniform.coefficients().begin(), uniform.coefficients().end()}, 0.1, Law::sign);
    for (double z : {0.5, 3.0, 10.0, 30.0}) {
        const Tail exact = exact_tail(t, z * t.sigma());
        REQUIRE_FALSE(exact.bound);
        CHECK(std::abs(saddlepoint_log10_tail(t, z * t.sigma()) - exact.log10_p) < 1e-3);
        CHECK(chernoff_log10_bound(t, z * t.sigma()) >= exact.log10_p);
    }
}
