// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cstdint>
#include <vector>

#include <wm3d/mesh/types.hpp>

/// SplitMix64 to (-1, 1): repeatable numbers for tests.
class Numbers {
public:
    explicit Numbers(std::uint64_t seed) : state_(seed) {}
    double operator()() {
        std::uint64_t z = (state_ += 0x9e3779b97f4a7c15u);
        z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
        z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
        return static_cast<double>((z ^ (z >> 31)) >> 11) * 0x1p-52 - 1 + 0x1p-53;
    }

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
