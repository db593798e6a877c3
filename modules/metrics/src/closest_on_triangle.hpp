// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Closest point of one triangle.
#pragma once

#include <wm3d/mesh/types.hpp>

namespace wm3d::metrics {

/// Barycentric coordinates of the point of triangle a b c that is closest to p; never NaN for finite corners.
inline Vec3 closest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    // By the region that p lies over: C. Ericson, "Real-Time Collision Detection" (2005), section 5.1.5.
    const Vec3 ab = b - a, ac = c - a;
    const auto along = [&](const Vec3& side, const Vec3& from) { return side.dot(p - from); };
    const double ab_a = along(ab, a), ac_a = along(ac, a);
    if (ab_a <= 0 && ac_a <= 0)
        return {1, 0, 0};
    const double ab_b = along(ab, b), ac_b = along(ac, b);
    if (ab_b >= 0 && ac_b <= ab_b)
        return {0, 1, 0};
    // Areas that p, seen along the normal, spans with the sides, times twice the area.
    const double of_c = ab_a * ac_b - ab_b * ac_a;
    if (of_c <= 0 && ab_a >= 0 && ab_b <= 0) {
        const double share = ab_a / (ab_a - ab_b);
        return {1 - share, share, 0};
    }
    const double ab_c = along(ab, c), ac_c = along(ac, c);
    if (ac_c >= 0 && ab_c <= ac_c)
        return {0, 0, 1};
    const double of_b = ab_c * ac_a - ab_a * ac_c;
    if (of_b <= 0 && ac_a >= 0 && ac_c <= 0) {
        const double share = ac_a / (ac_a - ac_c);
        return {1 - share, 0, share};
    }
    const double of_a = ab_b * ac_c - ab_c * ac_b;
    const double towards_c = ac_b - ab_b, towards_b = ab_c - ac_c;
    if (of_a <= 0 && towards_c >= 0 && towards_b >= 0) {
        const double share = towards_c / (towards_c + towards_b);
        return {0, 1 - share, share};
    }
    const double sum = of_a + of_b + of_c;
    return {1 - (of_b + of_c) / sum, of_b / sum, of_c / sum};
}

/// Of the closest point from p.
inline double squared_distance_to_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    const Vec3 w = closest_on_triangle(p, a, b, c);
    return (w[0] * a + w[1] * b + w[2] * c - p).squaredNorm();
}

} // namespace wm3d::metrics
