// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/search/harmonics.hpp>

#include <cmath>
#include <numbers>

#include <doctest/doctest.h>
#include <wm3d/core/error.hpp>

#include "random_points.hpp"

using namespace wm3d;
using namespace wm3d::search;

namespace {

double largest_difference(const Harmonics& a, const Harmonics& b) {
    double largest = 0;
    for (std::size_t k = 0; k < a.coefficients.size(); ++k)
        largest = std::max(largest, std::abs(a.coefficients[k] - b.coefficients[k]));
    return largest;
}

Harmonics random_harmonics(unsigned bandwidth, std::uint64_t seed) {
    const WeightedPoints points(50, seed);
    return direct_harmonics(points.directions, points.weights, bandwidth);
}

} // namespace

TEST_CASE("the first harmonics are the ones of the textbooks") {
    const Vec3 d = Vec3(0.3, -0.5, 0.7).normalized();
    const Harmonics f = direct_harmonics(std::vector{d}, std::vector{1.0}, 3);
    const double pi = std::numbers::pi;
    CHECK(f(0, 0).real() == doctest::Approx(0.5 / std::sqrt(pi)).epsilon(1e-14));
    CHECK(f(1, 0).real() == doctest::Approx(std::sqrt(0.75 / pi) * d.z()).epsilon(1e-14));
    CHECK(f(1, 1).real() == doctest::Approx(-std::sqrt(0.375 / pi) * d.x()).epsilon(1e-14));
    CHECK(f(1, 1).imag() == doctest::Approx(std::sqrt(0.375 / pi) * d.y()).epsilon(1e-14)); // the conjugate
    CHECK(f(2, 2).real() ==
          doctest::Approx(0.25 * std::sqrt(7.5 / pi) * (d.x() * d.x() - d.y() * d.y())).epsilon(1e-14));
    CHECK(f(2, 1).real() == doctest::Approx(-0.5 * std::sqrt(7.5 / pi) * d.x() * d.z()).epsilon(1e-14));
}

TEST_CASE("a degree's power doesn't change when the points are turned") {
    WeightedPoints points(40, 3);
    const std::vector<double> before = direct_harmonics(points.directions, points.weights, 40).power();
    const Mat3 turn = random_rotation(5);
    for (Vec3& d : points.directions)
        d = turn * d;
    const std::vector<double> after = direct_harmonics(points.directions, points.weights, 40).power();
    for (std::size_t l = 0; l < before.size(); ++l)
        CHECK(after[l] == doctest::Approx(before[l]).epsilon(1e-10));
}

TEST_CASE("analysis returns what was put together, and Parseval's sum is the integral of the square") {
    const unsigned bandwidth = 24;
    const Harmonics f = random_harmonics(bandwidth, 7);
    const HarmonicTransform transform(bandwidth, 2 * bandwidth);
    const Harmonics back = transform.of_function([&](const Vec3& d) { return evaluate(f, d); });
    CHECK(largest_difference(f, back) < 1e-11);

    double power = 0;
    for (double p : f.power())
        power += p;
    const HarmonicTransform finer(1, 4 * bandwidth); // the square has twice the degrees
    const Harmonics square = finer.of_function([&](const Vec3& d) { return std::pow(evaluate(f, d), 2); });
    CHECK(square(0, 0).real() * std::sqrt(4 * std::numbers::pi) == doctest::Approx(power).epsilon(1e-12));
}

TEST_CASE("points that are spread over a grid keep their harmonics") {
    const unsigned bandwidth = 32;
    WeightedPoints points(3000, 11);
    points.directions[0] = Vec3::UnitZ(); // poles
    points.directions[1] = -Vec3::UnitZ();
    const Harmonics exact = direct_harmonics(points.directions, points.weights, bandwidth);
    const Harmonics fast = HarmonicTransform(bandwidth).of_points(points.directions, points.weights);
    const Harmonics faster_still =
        HarmonicTransform(bandwidth, 128 * 8).of_points(points.directions, points.weights);
    const double scale = std::sqrt(exact.power().back() / (2 * bandwidth - 1));
    CHECK(largest_difference(exact, fast) < 0.05 * scale);
    CHECK(largest_difference(exact, faster_still) < 5e-5 * scale);
}

TEST_CASE("inversion takes every direction to its opposite") {
    const Harmonics f = random_harmonics(12, 1);
    const Vec3 d(0.1, 0.4, -0.3);
    CHECK(evaluate(f.inverted(), d) == doctest::Approx(evaluate(f, -d)).epsilon(1e-12));
}

TEST_CASE("too coarse a grid is refused, and points without direction are left out") {
    CHECK_THROWS_AS(HarmonicTransform(8, 14), ParameterError);
    CHECK_THROWS_AS(HarmonicTransform(0, 14), ParameterError);
    const Harmonics none = HarmonicTransform(4).of_points(std::vector<Vec3>{Vec3::Zero()}, std::vector{1.0});
    CHECK(none.power() == std::vector<double>(4, 0.0));
}
