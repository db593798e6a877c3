// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include <wm3d/core/split_mix.hpp>
#include <wm3d/mesh/types.hpp>

/// Numbers of (-1, 1): repeatable numbers for tests.
class Numbers {
public:
    explicit Numbers(std::uint64_t seed) : state_(seed) {}
    double operator()() { return static_cast<double>(wm3d::split_mix(state_) >> 11) * 0x1p-52 - 1 + 0x1p-53; }

private:
    std::uint64_t state_;
};

/// Weighted directions of all lengths.
struct WeightedPoints {
    std::vector<wm3d::Vec3> directions;
    std::vector<double> weights;

    WeightedPoints(std::size_t count, std::uint64_t seed) : directions(count), weights(count) {
        Numbers number(seed);
        for (wm3d::Vec3& d : directions)
            d = {number(), number(), number()};
        for (double& q : weights)
            q = number();
    }
};

inline wm3d::Mat3 random_rotation(std::uint64_t seed) {
    Numbers number(seed);
    return Eigen::Quaterniond(number(), number(), number(), number()).normalized().toRotationMatrix();
}
