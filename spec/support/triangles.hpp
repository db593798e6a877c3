// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Points and triangles of golden vectors.
#pragma once

#include <array>
#include <string>
#include <vector>

#include <wm3d/mesh/types.hpp>

#include "vectors.hpp"

namespace wm3d::spec {

inline std::vector<Vec3> points(const Vector& vector, const std::string& name) {
    std::vector<Vec3> result;
    for (const auto& p : vector.input<std::vector<std::array<double, 3>>>(name))
        result.push_back({p[0], p[1], p[2]});
    return result;
}

inline Vec3 point(const Vector& vector, const std::string& name) {
    const auto p = vector.input<std::array<double, 3>>(name);
    return {p[0], p[1], p[2]};
}

inline std::array<Vec3, 3> corners(const Vector& vector, const std::string& name) {
    const std::vector<Vec3> p = points(vector, name);
    return {p.at(0), p.at(1), p.at(2)};
}

inline std::vector<double> list(const Vec3& v) {
    return {v[0], v[1], v[2]};
}

} // namespace wm3d::spec
