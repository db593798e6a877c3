// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <cmath>
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

/// Points of the cube [-1, 1]^3: directions of all lengths, denser towards the corners.
inline std::vector<wm3d::Vec3> random_directions(std::size_t count, std::uint64_t seed) {
    Numbers number(seed);
    std::vector<wm3d::Vec3> directions(count);
    for (wm3d::Vec3& d : directions)
        d = {number(), number(), number()};
    return directions;
}

inline std::vector<double> random_heights(std::size_t count, double rmax, std::uint64_t seed) {
    Numbers number(seed);
    std::vector<double> heights(count);
    for (double& w : heights)
        w = rmax * number();
    return heights;
}
