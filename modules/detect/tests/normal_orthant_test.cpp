// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/detect/normal_orthant.hpp>

#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

using wm3d::detect::log10_normal_orthant;

namespace {

Eigen::MatrixXd equicorrelated(Eigen::Index n, double r) {
    return (1 - r) * Eigen::MatrixXd::Identity(n, n) + Eigen::MatrixXd::Constant(n, n, r);
}

double orthant(Eigen::Index n, double r, double limit, double mean = 0) {
    return log10_normal_orthant(Eigen::VectorXd::Constant(n, mean), equicorrelated(n, r),
                                Eigen::VectorXd::Constant(n, limit));
}

} // namespace

TEST_CASE("of one variable it is the normal distribution, to any depth") {
    CHECK(orthant(1, 0, 0) == doctest::Approx(std::log10(0.5)).epsilon(1e-14));
    // log10 Phi(-10) and log10 Phi(-40), from a table of 50 digits
    CHECK(orthant(1, 0, -10) == doctest::Approx(-23.1180534054860759).epsilon(1e-12));
    CHECK(orthant(1, 0, -30, 10) == doctest::Approx(-349.437006459345842).epsilon(1e-8));
}

TEST_CASE("quadrants of two and octants of three variables have closed forms") {
    for (double r : {-0.3, 0.0, 0.5, 0.9}) {
        const double quadrant = 0.25 + std::asin(r) / (2 * std::numbers::pi);
        CHECK(std::pow(10, orthant(2, r, 0)) == doctest::Approx(quadrant).epsilon(2e-3));
        const double octant = 0.125 + 3 * std::asin(r) / (4 * std::numbers::pi);
        CHECK(std::pow(10, orthant(3, r, 0)) == doctest::Approx(octant).epsilon(5e-3));
    }
}

TEST_CASE("independent variables multiply and equal ones count once, also far out") {
    CHECK(orthant(3, 0, -6) == doctest::Approx(3 * orthant(1, 0, -6)).epsilon(1e-3));
    CHECK(orthant(3, 1 - 1e-9, -30) == doctest::Approx(orthant(1, 0, -30)).epsilon(1e-3));
    CHECK(orthant(3, 1 - 1e-9, 1) == doctest::Approx(orthant(1, 0, 1)).epsilon(1e-3));
}
