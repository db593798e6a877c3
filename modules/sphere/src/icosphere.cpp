// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/sphere/icosphere.hpp>

#include <algorithm>

#include <fmt/format.h>

#include <wm3d/core/error.hpp>
#include <wm3d/core/parallel.hpp>

#include "subdivide.hpp"

namespace wm3d::sphere {

namespace {

/// Unit vector in a direction of any length that double can say; +z for zero.
Vec3 unit(const Vec3& direction) {
    const double largest = direction.cwiseAbs().maxCoeff();
    if (largest == 0)
        return Vec3::UnitZ();
    return (direction / largest).normalized(); // no overflow and no underflow to zero
}

/// d . (a x b): positive if d lies to the left of the arc from a to b. Written by differences, which keeps
/// all its digits where a and b are close to d.
double side(const Vec3& d, const Vec3& a, const Vec3& b) {
    return d.dot((a - d).cross(b - d));
}

} // namespace

Icosphere::Icosphere(unsigned level) {
    if (level > max_level)
        throw ParameterError(fmt::format(
            "level {} is too fine for a watermarking sphere; choose one from 0 to {}", level, max_level));
    vertices_ = icosahedron_vertices();
    faces_.push_back(icosahedron_faces());
    for (std::size_t f = 0; f < centres_.size(); ++f) {
        const auto& [a, b, c] = faces_[0][f];
        centres_[f] = vertices_[a] + vertices_[b] + vertices_[c];
    }
    for (unsigned l = 0; l < level; ++l)
        faces_.push_back(subdivide(faces_.back(), vertices_));
}

/// The face of the finest level in a direction.
std::size_t Icosphere::descend(const Vec3& d) const {
    // The cones of the icosahedron's faces are the Voronoi cells of the faces' centres.
    const auto nearest =
        std::ranges::max_element(centres_, {}, [&](const Vec3& centre) { return d.dot(centre); });
    auto face = static_cast<std::size_t>(nearest - centres_.begin());
    for (std::size_t l = 1; l < faces_.size(); ++l) {
        // Beyond one edge of the middle child lies the child at a corner; beyond two of them, rounding aside,
        // nothing.
        const auto& [ab, bc, ca] = faces_[l][4 * face + 3];
        const std::array<double, 3> beyond{side(d, vertices_[ab], vertices_[ca]),
                                           side(d, vertices_[bc], vertices_[ab]),
                                           side(d, vertices_[ca], vertices_[bc])};
        const auto furthest = std::ranges::max_element(beyond);
        face = 4 * face + (*furthest > 0 ? static_cast<std::size_t>(furthest - beyond.begin()) : 3);
    }
    return face;
}

SphereLocation Icosphere::locate(const Vec3& direction) const {
    return locate(direction, no_index);
}

SphereLocation Icosphere::locate(const Vec3& direction, Index guess) const {
    const Vec3 d = unit(direction);
    if (guess < faces().size())
        if (const Vec3 there = sides(d, level(), guess); there.minCoeff() > 0)
            return in_face(there, level(), guess);
    const std::size_t face = descend(d);
    return in_face(sides(d, level(), face), level(), face);
}

SphereLocation Icosphere::coarser(const Vec3& direction, const SphereLocation& fine, unsigned level) const {
    // Face f of a level lies in face f / 4 of the level before.
    const std::size_t face = fine.face >> (2 * (this->level() - level));
    return in_face(sides(unit(direction), level, face), level, face);
}

/// On which side of the face's three edges a direction lies, all positive inside.
Vec3 Icosphere::sides(const Vec3& d, unsigned level, std::size_t face) const {
    const Triangle& corners = faces_[level][face];
    const Vec3 &a = vertices_[corners[0]], &b = vertices_[corners[1]], &c = vertices_[corners[2]];
    return {side(d, b, c), side(d, c, a), side(d, a, b)};
}

SphereLocation Icosphere::in_face(Vec3 weights, unsigned level, std::size_t face) const {
    const Triangle& corners = faces_[level][face];
    const Vec3 &a = vertices_[corners[0]], &b = vertices_[corners[1]], &c = vertices_[corners[2]];
    weights = weights.cwiseMax(0.0); // rounding may leave a point on an edge a hair outside
    weights /= weights.sum();
    return {static_cast<Index>(face), corners, weights,
            (weights[0] * a + weights[1] * b + weights[2] * c).norm()};
}

std::vector<SphereLocation> Icosphere::locate(std::span<const Vec3> directions) const {
    std::vector<SphereLocation> result(directions.size());
    parallel_blocks(result.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            result[i] = locate(directions[i]);
    });
    return result;
}

} // namespace wm3d::sphere
