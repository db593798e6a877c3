// SPDX-License-Identifier: GPL-3.0-or-later
#include "polygons.hpp"

namespace wm3d::io {

namespace {

constexpr std::size_t most_clipped = 256;

/// Twice the area of the triangle p q r as seen along `normal`.
double signed_area(const Vec3& p, const Vec3& q, const Vec3& r, const Vec3& normal) {
    return (q - p).cross(r - p).dot(normal);
}

/// Area vector of a polygon, plane or not.
Vec3 newell_normal(std::span<const Vec3> positions, std::span<const Index> face) {
    const Vec3& origin = positions[face[0]];
    Vec3 sum = Vec3::Zero();
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
        sum += (positions[face[i]] - origin).cross(positions[face[i + 1]] - origin);
    return sum;
}

bool fan_is_upright(std::span<const Vec3> positions, std::span<const Index> face, const Vec3& normal) {
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
        if (signed_area(positions[face[0]], positions[face[i]], positions[face[i + 1]], normal) < 0)
            return false;
    return true;
}

void append_fan(std::span<const Index> face, std::vector<Triangle>& triangles) {
    for (std::size_t i = 1; i + 1 < face.size(); ++i)
        triangles.push_back({face[0], face[i], face[i + 1]});
}

/// Whether the corner at place i can be cut off: it is convex and no other corner lies in its triangle.
bool is_ear(std::span<const Vec3> positions, const std::vector<Index>& ring, std::size_t i,
            const Vec3& normal) {
    const std::size_t n = ring.size();
    const Index ia = ring[(i + n - 1) % n], ib = ring[i], ic = ring[(i + 1) % n];
    const Vec3 &a = positions[ia], &b = positions[ib], &c = positions[ic];
    if (!(signed_area(a, b, c, normal) > 0))
        return false;
    for (Index other : ring) {
        if (other == ia || other == ib || other == ic)
            continue;
        const Vec3& p = positions[other];
        if (signed_area(a, b, p, normal) >= 0 && signed_area(b, c, p, normal) >= 0 &&
            signed_area(c, a, p, normal) >= 0)
            return false;
    }
    return true;
}

void append_ears(std::span<const Vec3> positions, std::span<const Index> face, const Vec3& normal,
                 std::vector<Triangle>& triangles) {
    std::vector<Index> ring(face.begin(), face.end());
    while (ring.size() > 3) {
        const std::size_t n = ring.size();
        std::size_t ear = 0;
        while (ear < n && !is_ear(positions, ring, ear, normal))
            ++ear;
        if (ear == n) // folded over itself: no cut is better than another
            break;
        triangles.push_back({ring[(ear + n - 1) % n], ring[ear], ring[(ear + 1) % n]});
        ring.erase(ring.begin() + static_cast<std::ptrdiff_t>(ear));
    }
    append_fan(ring, triangles);
}

} // namespace

std::vector<Triangle> triangulate(std::span<const Vec3> positions, const Polygons& polygons) {
    std::vector<Triangle> triangles;
    if (polygons.corners.size() > 2 * polygons.size())
        triangles.reserve(polygons.corners.size() - 2 * polygons.size());
    std::size_t begin = 0;
    for (std::size_t end : polygons.ends) {
        const auto face = std::span(polygons.corners).subspan(begin, end - begin);
        begin = end;
        if (face.size() <= 3 || face.size() > most_clipped) {
            append_fan(face, triangles);
            continue;
        }
        const Vec3 normal = newell_normal(positions, face);
        if (fan_is_upright(positions, face, normal))
            append_fan(face, triangles);
        else
            append_ears(positions, face, normal, triangles);
    }
    return triangles;
}

void append_strip(std::span<const Index> strip, std::vector<Triangle>& triangles) {
    for (std::size_t i = 0; i + 2 < strip.size(); ++i) {
        if (i % 2 == 0)
            triangles.push_back({strip[i], strip[i + 1], strip[i + 2]});
        else
            triangles.push_back({strip[i + 1], strip[i], strip[i + 2]});
    }
}

} // namespace wm3d::io
