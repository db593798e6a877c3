// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The spherical mesh of section 2.2.1 of the paper: an icosahedron subdivided `level` times.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::sphere {

/// Finest level: 2 621 442 vertices and 5 242 880 faces, in about 150 MB.
inline constexpr unsigned max_level = 9;

/// Where the ray from the centre in some direction meets the flat faces of the sphere of radius 1.
struct SphereLocation {
    Index face = no_index;           ///< face of the finest level
    Triangle vertices{};             ///< its corners
    Vec3 barycentric = Vec3::Zero(); ///< coordinates of the meeting point in the flat face; >= 0, sum 1
    double flat_radius = 1;          ///< distance of the meeting point from the centre, just below 1
};

/// Unit sphere of 10 * 4^level + 2 vertices and 20 * 4^level faces, oriented outwards.
///
/// Vertices 0 to 11 are the icosahedron's: (0, s, t phi) over its length, for s = 1, 1, -1, -1 and t = 1, -1,
/// 1, -1, then the same with the coordinates shifted to (t phi, 0, s), then to (s, t phi, 0). Every
/// subdivision adds one vertex per edge, its midpoint projected on the sphere; new vertices are numbered by a
/// walk over the coarser faces in order, edges (0, 1), (1, 2), (2, 0) of each. So the vertices of a coarser
/// level are a prefix. Face f becomes the faces 4f to 4f + 3: those at its corners 0, 1, 2 and the middle
/// one. Coordinates come from +, *, / and sqrt in a fixed order and have the same bits everywhere.
class Icosphere {
public:
    /// \throw ParameterError  if level > max_level
    explicit Icosphere(unsigned level);

    unsigned level() const { return static_cast<unsigned>(faces_.size()) - 1; }
    const std::vector<Vec3>& vertices() const { return vertices_; }
    const std::vector<Triangle>& faces() const { return faces_.back(); }
    TriangleMesh mesh() const { return {vertices_, faces()}; }

    /// Finds the face in `direction` by descent through the levels. The length of `direction` doesn't matter;
    /// of zero, which has no direction, the answer is that of +z. On an edge or a vertex any face around it
    /// is right.
    /// \pre  the coordinates are finite
    SphereLocation locate(const Vec3& direction) const;

    /// The same, looking at face `guess` first: for a direction that moves little from one call to the next.
    /// Any number may be guessed.
    SphereLocation locate(const Vec3& direction, Index guess) const;

    /// `locate` for every direction, in parallel.
    std::vector<SphereLocation> locate(std::span<const Vec3> directions) const;

private:
    friend class Descent;

    std::size_t root(const Vec3& unit_direction) const;
    std::size_t child(const Vec3& unit_direction, unsigned level, std::size_t parent) const;
    Vec3 sides(const Vec3& unit_direction, unsigned level, std::size_t face) const;
    Vec3 weights(const Vec3& unit_direction, unsigned level, std::size_t face) const;
    SphereLocation in_face(const Vec3& weights, unsigned level, std::size_t face) const;

    std::vector<Vec3> vertices_;
    std::vector<std::vector<Triangle>> faces_; ///< of level 0, 1, ..., level
    std::array<Vec3, 20> centres_;             ///< of the icosahedron's faces
};

/// Many directions on their way down through the levels of a sphere, which has to outlive it. Each step is one loop
/// over all of them, so that none waits for another.
class Descent {
public:
    /// Starts at level 0. Any length of the directions is right, as for `Icosphere::locate`.
    Descent(const Icosphere& sphere, std::span<const Vec3> directions);

    unsigned level() const { return level_; }

    /// On to the next level.
    /// \pre  level() < the sphere's
    void refine();

    /// Corners of the face in direction i.
    const Triangle& corners(std::size_t i) const { return sphere_.faces_[level_][faces_[i]]; }

    /// Barycentric coordinates in it; >= 0, sum 1.
    Vec3 weights(std::size_t i) const { return sphere_.weights(units_[i], level_, faces_[i]); }

private:
    const Icosphere& sphere_;
    unsigned level_ = 0;
    std::vector<Vec3> units_;
    std::vector<std::size_t> faces_;
};

} // namespace wm3d::sphere
