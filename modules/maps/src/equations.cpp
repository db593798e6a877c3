// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/maps/equations.hpp>

#include <algorithm>

namespace wm3d::maps {

namespace {

/// Coordinates on the longest side of a triangle without area; on a single point, the first corner.
Vec3 on_longest_side(const Vec3& p, const Corners& t) {
    int from = 0;
    double longest = 0;
    for (int k = 0; k < 3; ++k)
        if (const double length = (t[(k + 1) % 3] - t[k]).squaredNorm(); length > longest) {
            longest = length;
            from = k;
        }
    Vec3 coordinates = Vec3::Unit(from);
    if (longest > 0) {
        const int to = (from + 1) % 3;
        const double s = std::clamp((p - t[from]).dot(t[to] - t[from]) / longest, 0.0, 1.0);
        coordinates[from] = 1 - s;
        coordinates[to] = s;
    }
    return coordinates;
}

} // namespace

Vec3 base_point(const Corners& base_triangle, const Vec3& barycentric) {
    return barycentric[0] * base_triangle[0] + barycentric[1] * base_triangle[1] +
           barycentric[2] * base_triangle[2]; // eq. (1)
}

Vec3 barycentric_coordinates(const Vec3& p, const Corners& triangle) {
    const Vec3 e1 = triangle[1] - triangle[0], e2 = triangle[2] - triangle[0], d = p - triangle[0];
    const Vec3 normal = e1.cross(e2);
    const double square = normal.squaredNorm();
    // a thinner triangle than this has lost its plane to rounding
    if (!(square > 1e-28 * e1.squaredNorm() * e2.squaredNorm()))
        return on_longest_side(p, triangle);
    const double beta = d.cross(e2).dot(normal) / square;
    const double gamma = e1.cross(d).dot(normal) / square;
    return {1 - beta - gamma, beta, gamma};
}

Vec3 original_point(const Vec3& p, const Corners& images, const Corners& originals) {
    // p = alpha Pi(p_i) + beta Pi(p_j) + gamma Pi(p_k)
    return original_point(barycentric_coordinates(p, images), originals);
}

Vec3 original_point(const Vec3& barycentric, const Corners& originals) {
    return barycentric[0] * originals[0] + barycentric[1] * originals[1] +
           barycentric[2] * originals[2]; // eq. (2)
}

} // namespace wm3d::maps
