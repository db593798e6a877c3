// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The closest point of a surface.
#pragma once

#include <memory>
#include <span>

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
    /// \throw GeometryError  if the mesh has no triangle with an area
    explicit SurfaceTree(const TriangleMesh& mesh);
    ~SurfaceTree();
    SurfaceTree(SurfaceTree&&) noexcept;
    SurfaceTree& operator=(SurfaceTree&&) noexcept;

    /// Of triangles that are equally close, that of lowest number.
    ClosestPoint closest(const Vec3& query) const;

    /// The same point, found sooner where one of the triangles `likely` is close to the query.
    ClosestPoint closest(const Vec3& query, std::span<const Index> likely) const;

    const TriangleMesh& mesh() const { return *mesh_; }

private:
    const TriangleMesh* mesh_;
    std::unique_ptr<class TriangleBoxes> boxes_;
};

} // namespace wm3d::metrics
