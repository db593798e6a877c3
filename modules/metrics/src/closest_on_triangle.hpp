// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Closest point of one triangle.
#pragma once

#include <wm3d/mesh/types.hpp>

namespace wm3d::metrics {

/// Barycentric coordinates of the point of triangle a b c that is closest to p; never NaN for finite corners.
Vec3 closest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

/// Of the closest point from p.
inline double squared_distance_to_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 w = closest_on_triangle(p, a, b, c);
    return (w[0] * a + w[1] * b + w[2] * c - p).squaredNorm();
}

} // namespace wm3d::metrics
