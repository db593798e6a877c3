// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The closest point of a surface.
#pragma once

#include <limits>
#include <memory>
#include <span>
#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::metrics {

/// A point of the surface and how far away it is.
struct ClosestPoint {
    SurfacePoint at;
    Vec3 position = Vec3::Zero();
    double distance = 0; ///< in units of the mesh
};

/// A tree of boxes over the triangles of a mesh. Triangles without area are left out. Queries may run on
/// several threads. The mesh must outlive the tree.
class SurfaceTree {
public:
    /// When the tree is made: whoever asks for little but what is known without it may never need it.
    enum class Made { at_once, at_need };

    /// \throw GeometryError  if the mesh has no triangle with an area
    explicit SurfaceTree(const TriangleMesh& mesh, Made made = Made::at_once);
    ~SurfaceTree();
    SurfaceTree(SurfaceTree&&) noexcept;
    SurfaceTree& operator=(SurfaceTree&&) noexcept;

    /// Of triangles that are equally close, as beyond a convex edge, the one that faces the query most
    /// squarely.
    ClosestPoint closest(const Vec3& query) const;

    /// The same point, found sooner the closer triangle `near` is to the query.
    ClosestPoint closest(const Vec3& query, Index near) const;

    /// The same point, found sooner the closer `known`, a corner of triangle `of`, is to the query.
    ClosestPoint closest(const Vec3& query, Index known, Index of) const;

    /// The closest point of some triangles.
    /// \pre  one of them has an area
    ClosestPoint closest_of(std::span<const Index> triangles, const Vec3& query) const;

    /// The point of a triangle that is closest to the query.
    ClosestPoint on(Index triangle, const Vec3& query) const;

    /// Distance of each vertex of the mesh from the triangles with an area that it is no corner of, #V, or `most` if
    /// they are all farther: the less that is, the shorter the search. 0 for corners of no triangle with an area.
    std::vector<double> clearances(double most) const;

    const TriangleMesh& mesh() const { return *mesh_; }

    /// Whether a triangle of the mesh is in the tree.
    bool has_area(Index triangle) const { return has_area_[triangle] != 0; }

    /// The triangles that are, ascending.
    std::vector<Index> with_area() const;

private:
    struct Boxes; ///< made when they are first asked for
    const class TriangleBoxes& boxes() const;

    const TriangleMesh* mesh_;
    std::vector<char> has_area_; ///< #F
    std::unique_ptr<Boxes> boxes_;
};

} // namespace wm3d::metrics
