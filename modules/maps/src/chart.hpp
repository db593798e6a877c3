// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Unfolding part of the base domain into a plane.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>

#include "flatten.hpp"

namespace wm3d::maps {

/// A base triangle laid into the plane.
struct LaidOut {
    Index triangle;
    std::array<Vec2, 3> corners;
};

/// Unfolds the base mesh around three of its points until all of them are met.
class Unfolder {
public:
    explicit Unfolder(const TriangleMesh& base);

    /// Lays out the triangles around `points`, breadth first from one that holds as many of them as possible.
    /// False if they are not met within a few hundred triangles.
    bool unfold(std::span<const SurfacePoint, 3> points);

    const std::vector<LaidOut>& triangles() const { return laid_out_; } ///< in order of distance
    const std::array<Vec2, 3>& points() const { return found_; }        ///< the three points in the plane

private:
    Index home_of(std::span<const SurfacePoint, 3> points) const;
    bool holds(Index triangle, const SurfacePoint& point) const;
    bool meet(const LaidOut& laid, std::span<const SurfacePoint, 3> points);
    LaidOut lay_first(Index triangle) const;
    LaidOut lay_beside(const LaidOut& from, Index side, Index half_edge) const;

    const TriangleMesh& base_;
    std::vector<Index> beside_;            ///< 3 #F: the next half-edge of the same edge, in a cycle
    std::vector<Index> star_start_, star_; ///< triangles of each vertex
    std::vector<unsigned> visited_;        ///< #F: last unfolding that met the triangle
    unsigned turn_ = 0;
    std::vector<LaidOut> laid_out_;
    std::array<Vec2, 3> found_;
    std::array<bool, 3> met_{};
};

} // namespace wm3d::maps
