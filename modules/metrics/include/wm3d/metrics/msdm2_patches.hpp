// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  MSDM2 of dense meshes, patch by patch: in time that grows with the vertices and not with their square, and in
/// the memory of a few patches.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>
#include <wm3d/metrics/msdm2.hpp>

namespace wm3d::metrics {

/// One-sided MSDM2 at some windows of a mesh, seen from a reference of the same triangles. No structure of the whole
/// mesh is made: windows that lie together are opened in a patch of the surface, which has its own.
///
/// The point of the reference that a vertex is matched with is looked for from the vertex's own triangles, from one to
/// the next as long as that comes closer, so this is for moves that are small and about along the normals, as marks are.
/// Where that is the closest point of all, patches tell what `Msdm2::sample` tells, to single precision of the
/// reference's curvatures.
///
/// Where windows hold more than `window_vertices` vertices, about, one in `stride` stands for the others: those whose
/// number is a multiple of it, each with its full curvature. The points where a window's rim is crossed then have the
/// curvature of the edge's inner end; from a stride of 8 on, C^ is C of the reference's vertex.
///
/// The same bytes at any number of threads. Calls may run at the same time.
class Msdm2Patches {
public:
    /// \param reference  has to outlive the object; quick if its vertices and triangles come `along_curve`
    /// \throw GeometryError  if the mesh has no triangle
    explicit Msdm2Patches(const TriangleMesh& reference, const Msdm2Options& options = {});
    ~Msdm2Patches();
    Msdm2Patches(Msdm2Patches&&) noexcept;
    Msdm2Patches& operator=(Msdm2Patches&&) noexcept;

    static constexpr std::size_t usual_window_vertices = 256;

    /// Local distances at every k-th vertex of a triangle, at most `windows`, with the reference's S.
    /// \param distorted  where the reference's vertices went, #V
    /// \pre  windows > 0, window_vertices > 0
    Msdm2Sample sample(const std::vector<Vec3>& distorted, std::size_t windows,
                       std::size_t window_vertices = usual_window_vertices) const;

    /// Local distances at some vertices.
    /// \param vertices  ascending, none twice, each of a triangle
    /// \pre  vertices is not empty
    Msdm2Sample at(const std::vector<Vec3>& distorted, std::vector<Index> vertices,
                   std::size_t window_vertices = usual_window_vertices) const;

    /// One in so many vertices is looked at.
    std::size_t stride(std::size_t window_vertices = usual_window_vertices) const;

private:
    struct Prepared;
    std::unique_ptr<Prepared> prepared_;
};

} // namespace wm3d::metrics
