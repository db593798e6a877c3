// SPDX-License-Identifier: GPL-3.0-or-later
#include "noise.hpp"

#include <cmath>

#include <wm3d/core/split_mix.hpp>

namespace wm3d::shapes {

namespace {

/// A slope that depends on the lattice point and the seed alone.
Vec3 lattice_slope(const std::array<std::int64_t, 3>& cell, std::uint64_t seed) {
    std::uint64_t state = seed;
    for (const std::int64_t c : cell) {
        state ^= static_cast<std::uint64_t>(c) * 0xd6e8feb86659fd93u;
        signed_unit(state);
        state ^= state >> 29;
        state *= 0xbf58476d1ce4e5b9u;
    }
    Vec3 slope;
    for (int axis = 0; axis < 3; ++axis)
        slope[axis] = signed_unit(state);
    return slope;
}

} // namespace

double signed_unit(std::uint64_t& state) {
    return static_cast<double>(split_mix(state) >> 11) * 0x1p-52 - 1.0;
}

double gradient_noise(const Vec3& p, std::uint64_t seed) {
    const Vec3 base = p.array().floor();
    const Vec3 t = p - base;
    const Vec3 blend = t.unaryExpr([](double x) { return x * x * x * (x * (6 * x - 15) + 10); });
    double sum = 0;
    for (int corner = 0; corner < 8; ++corner) {
        const Vec3 step(corner & 1, corner >> 1 & 1, corner >> 2 & 1);
        double weight = 1;
        std::array<std::int64_t, 3> cell{};
        for (int axis = 0; axis < 3; ++axis) {
            weight *= step[axis] > 0 ? blend[axis] : 1 - blend[axis];
            cell[static_cast<std::size_t>(axis)] = static_cast<std::int64_t>(base[axis] + step[axis]);
        }
        sum += weight * lattice_slope(cell, seed).dot(t - step);
    }
    return sum;
}

} // namespace wm3d::shapes
