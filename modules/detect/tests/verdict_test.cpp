// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/detect/verdict.hpp>

#include <cmath>

#include <Eigen/Dense>
#include <doctest/doctest.h>
#include <wm3d/core/split_mix.hpp>
#include <wm3d/detect/linear_statistic.hpp>
#include <wm3d/shapes/shapes.hpp>
#include <wm3d/sphere/icosphere.hpp>
#include <wm3d/sphere/sparse_rows.hpp>

using namespace wm3d;
using namespace wm3d::detect;

namespace {

/// The most that any numbers of the vertices make of a sequence: T over its deviation is largest for (B B^T)^-1 B w.
double best_sigmas(const Eigen::MatrixXd& b, const Eigen::VectorXd& w) {
    const Eigen::VectorXd q = (b * b.transpose()).ldlt().solve(b * w);
    const Eigen::VectorXd c = b.transpose() * q;
    const LinearStatistic t({c.begin(), c.end()}, 1);
    return t.value(std::span(w.data(), w.data() + w.size())) / t.sigma();
}

} // namespace

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

TEST_CASE("the tail of a normal score") {
    CHECK(normal_sigmas(-6) == doctest::Approx(4.753424).epsilon(1e-6));
    CHECK(normal_sigmas(std::log10(0.5)) == doctest::Approx(0).epsilon(1e-9));
}

TEST_CASE("whatever few vertices say, all keys but few score below what so many vertices can show") {
    const TriangleMesh mesh = shapes::ellipsoid({1, 1.3, 1.7}, 5);
    const std::size_t n = mesh.positions.size();
    const sphere::SparseRows rows = sphere::barycentric_rows(sphere::Icosphere(4), mesh.positions);
    Eigen::MatrixXd b =
        Eigen::MatrixXd::Zero(static_cast<Eigen::Index>(n), static_cast<Eigen::Index>(rows.columns));
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = 0; k < 3; ++k)
            b(static_cast<Eigen::Index>(i), rows.indices[i][k]) += rows.weights[i][k];
    std::uint64_t state = 7;
    constexpr int keys = 1000;
    int above_limit = 0, above_root = 0;
    for (int k = 0; k < keys; ++k) {
        Eigen::VectorXd w(b.cols());
        for (double& x : w)
            x = std::ldexp(static_cast<double>(split_mix(state) >> 11), -52) - 1;
        const double best = best_sigmas(b, w);
        above_limit += best > most_sigmas(n) ? 1 : 0;
        above_root += best > std::sqrt(static_cast<double>(n)) ? 1 : 0;
    }
    CHECK(above_limit <= keys / 100);
    CHECK(above_root > keys / 4); // the limit is near
    CHECK(most_sigmas(100) == doctest::Approx(13.035).epsilon(1e-4));
}
