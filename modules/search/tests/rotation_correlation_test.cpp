// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/search/rotation_correlation.hpp>

#include <cmath>
#include <map>
#include <vector>

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
    const auto check = [&](std::size_t a, std::size_t b, std::size_t c, Real value) {
        const Mat3 rotation = correlation.rotation(a, b, c);
        double sum = 0;
        for (std::size_t i = 0; i < points.directions.size(); ++i)
            sum += points.weights[i] * evaluate(w, rotation * points.directions[i]);
        scale = std::max(scale, std::abs(sum));
        error = std::max(error, std::abs(value - sum));
    };
    std::size_t angles = 0;
    correlation({&f, 1}, w, [&](std::size_t, std::size_t b, std::span<const std::complex<Real>> values) {
        angles += 2;
        for (int k = 0; k < 4; ++k) {
            const auto a = static_cast<std::size_t>((number() + 1) / 2 * samples),
                       c = static_cast<std::size_t>((number() + 1) / 2 * samples);
            check(a, b, c, values[a * samples + c].real());
            check(a, samples - 1 - b, c, values[a * samples + c].imag());
        }
    });
    CHECK(angles == samples);
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
    const auto look = [&](std::size_t k, std::size_t b, float value) {
        if (value > best) {
            best = value;
            found = correlation.rotation(k / samples, b, k % samples);
        }
    };
    correlation({&f, 1}, w, [&](std::size_t, std::size_t b, std::span<const std::complex<float>> values) {
        for (std::size_t k = 0; k < values.size(); ++k) {
            look(k, b, values[k].real());
            look(k, samples - 1 - b, values[k].imag());
        }
    });
    const double degrees = Eigen::AngleAxisd(Mat3(found * turn.transpose())).angle() * 57.3;
    CHECK(degrees < 180.0 / bandwidth);
}

TEST_CASE("several functions together give the same numbers as each by itself") {
    const unsigned bandwidth = 19, samples = 38;
    WeightedPoints key(60, 1);
    const Harmonics w = direct_harmonics(key.directions, key.weights, bandwidth);
    std::vector<Harmonics> f;
    for (std::uint64_t seed = 2; seed < 5; ++seed) {
        WeightedPoints points(80, seed);
        f.push_back(direct_harmonics(points.directions, points.weights, bandwidth));
    }
    const RotationCorrelation<float> correlation(bandwidth, samples);
    using Values = std::vector<std::complex<float>>;
    std::map<std::pair<std::size_t, std::size_t>, Values> together;
    correlation(f, w, [&](std::size_t k, std::size_t b, std::span<const std::complex<float>> values) {
        together[{k, b}] = Values(values.begin(), values.end());
    });
    CHECK(together.size() == f.size() * samples / 2);
    for (std::size_t k = 0; k < f.size(); ++k)
        correlation({&f[k], 1}, w,
                    [&](std::size_t, std::size_t b, std::span<const std::complex<float>> values) {
                        CHECK(together[{k, b}] == Values(values.begin(), values.end()));
                    });
}

TEST_CASE("too few samples are refused") {
    CHECK_THROWS_AS(RotationCorrelation<float>(8, 14), ParameterError);
    CHECK_THROWS_AS(RotationCorrelation<float>(8, 17), ParameterError);
    CHECK_THROWS_AS(RotationCorrelation<float>(0, 2), ParameterError);
}
