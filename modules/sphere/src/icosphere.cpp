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
/// \param to_a, to_b  a - d and b - d
inline double side(const Vec3& d, const Vec3& to_a, const Vec3& to_b) {
    return d.dot(to_a.cross(to_b));
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

/// The face of level 0 in a direction: the cones of the icosahedron's faces are the Voronoi cells of their centres.
std::size_t Icosphere::root(const Vec3& d) const {
    std::size_t nearest = 0;
    double largest = d.dot(centres_[0]);
    for (std::size_t f = 1; f < centres_.size(); ++f) {
        const double along = d.dot(centres_[f]);
        nearest = along > largest ? f : nearest;
        largest = std::max(largest, along);
    }
    return nearest;
}

/// The face of this level in a direction, which lies in the face `parent` of the level before. Nothing branches
/// here: which child it is can't be foretold.
std::size_t Icosphere::child(const Vec3& d, unsigned level, std::size_t parent) const {
    // Beyond one edge of the middle child lies the child at a corner; beyond two of them, rounding aside, nothing.
    const auto& [ab, bc, ca] = faces_[level][4 * parent + 3];
    const Vec3 to_ab = vertices_[ab] - d, to_bc = vertices_[bc] - d, to_ca = vertices_[ca] - d;
    const double beyond_a = side(d, to_ab, to_ca), beyond_b = side(d, to_bc, to_ab),
                 beyond_c = side(d, to_ca, to_bc);
    std::size_t corner = beyond_b > beyond_a ? 1 : 0;
    double furthest = std::max(beyond_a, beyond_b);
    corner = beyond_c > furthest ? 2 : corner;
    furthest = std::max(furthest, beyond_c);
    return 4 * parent + (furthest > 0 ? corner : 3);
}

SphereLocation Icosphere::locate(const Vec3& direction) const {
    return locate(direction, no_index);
}

SphereLocation Icosphere::locate(const Vec3& direction, Index guess) const {
    const Vec3 d = unit(direction);
    if (guess < faces().size())
        if (const Vec3 there = sides(d, level(), guess); there.minCoeff() > 0)
            return in_face(there / there.sum(), level(), guess);
    std::size_t face = root(d);
    for (unsigned l = 1; l <= level(); ++l)
        face = child(d, l, face);
    return in_face(weights(d, level(), face), level(), face);
}

/// On which side of the face's three edges a direction lies, all positive inside.
Vec3 Icosphere::sides(const Vec3& d, unsigned level, std::size_t face) const {
    const Triangle& corners = faces_[level][face];
    const Vec3 a = vertices_[corners[0]] - d, b = vertices_[corners[1]] - d, c = vertices_[corners[2]] - d;
    return {side(d, b, c), side(d, c, a), side(d, a, b)};
}

/// Barycentric coordinates, in a face, of the point in a direction.
Vec3 Icosphere::weights(const Vec3& d, unsigned level, std::size_t face) const {
    const Vec3 inside =
        sides(d, level, face).cwiseMax(0.0); // rounding may leave a point on an edge a hair outside
    return inside / inside.sum();
}

SphereLocation Icosphere::in_face(const Vec3& weights, unsigned level, std::size_t face) const {
    const Triangle& corners = faces_[level][face];
    const Vec3 &a = vertices_[corners[0]], &b = vertices_[corners[1]], &c = vertices_[corners[2]];
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

Descent::Descent(const Icosphere& sphere, std::span<const Vec3> directions)
    : sphere_(sphere), units_(directions.size()), faces_(directions.size()) {
    std::ranges::transform(directions, units_.begin(), unit);
    std::ranges::transform(units_, faces_.begin(), [&](const Vec3& d) { return sphere_.root(d); });
}

void Descent::refine() {
    ++level_;
    for (std::size_t i = 0; i < faces_.size(); ++i)
        faces_[i] = sphere_.child(units_[i], level_, faces_[i]);
}

} // namespace wm3d::sphere
