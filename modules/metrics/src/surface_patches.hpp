// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Parts of a large mesh, as meshes of their own.
#pragma once

#include <vector>

#include <wm3d/mesh/measure.hpp>
#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::metrics {

/// A part of a mesh.
struct SurfacePatch {
    TriangleMesh mesh;
    std::vector<Index> vertices; ///< numbers in the whole mesh, ascending

    /// Number in the patch of a vertex of the whole mesh.
    /// \pre  the patch has it
    Index local(Index vertex) const;
};

/// Finds the triangles of boxes. Keeps the boxes of runs of consecutive triangles and nothing else, so it is quick where
/// triangles come along a space-filling curve.
class SurfacePatches {
public:
    /// The mesh has to outlive the object.
    explicit SurfacePatches(const TriangleMesh& mesh);

    /// Takes, in the memory of a patch, the triangles whose own boxes meet this one, with their corners, all in the order of
    /// the mesh.
    void take(const Box& box, SurfacePatch& patch) const;

private:
    template<typename Visitor>
    void for_each_run(const Box& box, Visitor&& visit) const;

    const TriangleMesh& mesh_;
    std::vector<Box> runs_;         ///< of triangles
    std::vector<Box> runs_of_runs_; ///< of those boxes
};

/// Vertices that lie close together.
struct VertexGroup {
    std::vector<Index> vertices; ///< ascending
    Box box;                     ///< of their positions
};

/// Vertices sorted into the cells of a grid, 2^bits along each side of the mesh's bounding cube.
/// \pre  bits <= morton_bits
std::vector<VertexGroup> groups_of(const TriangleMesh& mesh, const std::vector<Index>& vertices, int bits);

} // namespace wm3d::metrics
