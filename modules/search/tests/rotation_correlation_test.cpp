// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/search/rotation_correlation.hpp>

#include <cmath>

#include <doctest/doctest.h>
#include <wm3d/core/error.hpp>

#include "random_points.hpp"

using namespace wm3d;
using namespace wm3d::search;

namespace {

/// Largest relative difference of the transform from the sum over points, at rotations all over the grid.
template<typename Real>
double error_against_sum(unsigned bandwidth, unsigned samples, std::uint64_t seed) {
    WeightedPoints points(200, seed), key(60, seed + 1);
    const Mat3 turn = random_rotation(seed + 2); // so that the grid's rotations are any rotations
    for (Vec3& d : points.directions)
        d = turn * d;
    const Harmonics f = direct_harmonics(points.directions, points.weights, bandwidth);
    const Harmonics w = direct_harmonics(key.directions, key.weights, bandwidth);
    const RotationCorrelation<Real> correlation(bandwidth, samples);
    double scale = 0, error = 0;
    Numbers number(seed);
    correlation(f, w, [&](std::size_t b, std::span<const Real> values) {
        for (int k = 0; k < 4; ++k) {
            const auto a = static_cast<std::size_t>((number() + 1) / 2 * samples),
                       c = static_cast<std::size_t>((number() + 1) / 2 * samples);
            const Mat3 rotation = correlation.rotation(a, b, c);
            double sum = 0;
            for (std::size_t i = 0; i < points.directions.size(); ++i)
                sum += points.weights[i] * evaluate(w, rotation * points.directions[i]);
            scale = std::max(scale, std::abs(sum));
            error = std::max(error, std::abs(values[a * samples + c] - sum));
        }
    });
    return error / scale;
}

} // namespace

TEST_CASE("the transform is the sum over the points, at any rotation") {
    CHECK(error_against_sum<double>(17, 36, 1) < 1e-11);
    CHECK(error_against_sum<double>(48, 96, 2) < 1e-9);
    CHECK(error_against_sum<double>(1, 2, 3) < 1e-11);
    CHECK(error_against_sum<float>(48, 96, 2) < 3e-5);
}

TEST_CASE("of a function and its turned copy, the correlation is largest at the turn") {
    const unsigned bandwidth = 32, samples = 64;
    WeightedPoints points(500, 4);
    const Harmonics f = direct_harmonics(points.directions, points.weights, bandwidth);
    const Mat3 turn = random_rotation(9);
    for (Vec3& d : points.directions)
        d = turn * d;
    const Harmonics w = direct_harmonics(points.directions, points.weights, bandwidth);
    const RotationCorrelation<float> correlation(bandwidth, samples);
    float best = 0;
    Mat3 found = Mat3::Identity();
    correlation(f, w, [&](std::size_t b, std::span<const float> values) {
        for (std::size_t k = 0; k < values.size(); ++k)
            if (values[k] > best) {
                best = values[k];
                found = correlation.rotation(k / samples, b, k % samples);
            }
    });
    const double degrees = Eigen::AngleAxisd(Mat3(found * turn.transpose())).angle() * 57.3;
    CHECK(degrees < 180.0 / bandwidth);
}

TEST_CASE("too few samples are refused") {
    CHECK_THROWS_AS(RotationCorrelation<float>(8, 14), ParameterError);
    CHECK_THROWS_AS(RotationCorrelation<float>(8, 17), ParameterError);
    CHECK_THROWS_AS(RotationCorrelation<float>(0, 2), ParameterError);
}
