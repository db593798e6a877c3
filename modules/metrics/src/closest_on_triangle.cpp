// SPDX-License-Identifier: GPL-3.0-or-later
#include "closest_on_triangle.hpp"

#include <algorithm>

namespace wm3d::metrics {

namespace {

/// Share of b in the point of segment a-b closest to p.
double along_segment(const Vec3& p, const Vec3& a, const Vec3& b) {
    const Vec3 side = b - a;
    const double square = side.squaredNorm();
    return square > 0 ? std::clamp((p - a).dot(side) / square, 0.0, 1.0) : 0.0;
}

} // namespace

Vec3 closest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c) {
    // Inside: areas of the three parts, seen along the normal.
    const Vec3 normal = (b - a).cross(c - a);
    const double square = normal.squaredNorm();
    if (square > 0) {
        const double wb = (p - a).cross(c - a).dot(normal) / square;
        const double wc = (b - a).cross(p - a).dot(normal) / square;
        if (wb >= 0 && wc >= 0 && wb + wc <= 1)
            return {1 - wb - wc, wb, wc};
    }
    // Outside, or no area: the best of the three sides.
    const double ab = along_segment(p, a, b), bc = along_segment(p, b, c), ca = along_segment(p, c, a);
    const Vec3 candidates[] = {{1 - ab, ab, 0}, {0, 1 - bc, bc}, {ca, 0, 1 - ca}};
    const auto distance = [&](const Vec3& w) { return (w[0] * a + w[1] * b + w[2] * c - p).squaredNorm(); };
    return *std::min_element(std::begin(candidates), std::end(candidates),
                             [&](const Vec3& u, const Vec3& v) { return distance(u) < distance(v); });
}

} // namespace wm3d::metrics
