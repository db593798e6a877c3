// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  What a mesh is made of: parts, holes and places where it is no manifold.
#pragma once

#include <cstddef>
#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d {

/// Facts about a mesh as it is indexed; weld it first if positions that coincide should count as one.
struct Topology {
    std::size_t components = 0;           ///< sets of triangles connected by vertices
    std::size_t edges = 0;                ///< pairs of vertices that some triangle joins
    std::size_t boundary_edges = 0;       ///< edges of one triangle
    std::size_t boundary_loops = 0;       ///< connected sets of boundary edges
    std::size_t non_manifold_edges = 0;   ///< edges of three triangles or more
    std::size_t misoriented_edges = 0;    ///< edges of two triangles that walk it in the same direction
    std::size_t isolated_vertices = 0;    ///< vertices of no triangle
    std::size_t degenerate_triangles = 0; ///< triangles that repeat a corner or have no area
    long euler_characteristic = 0;        ///< used vertices - edges + triangles

    /// Every edge has two triangles that agree on the outside.
    bool closed() const { return boundary_edges + non_manifold_edges + misoriented_edges == 0; }
};

Topology inspect_topology(const TriangleMesh& mesh);

/// A connected set of boundary edges.
struct BorderLoop {
    std::size_t edges = 0;
    double length = 0;          ///< in units of the mesh
    Vec3 centre = Vec3::Zero(); ///< of its edges, by their lengths
    /// Area vector of any surface that closes the loop; near 0 for a crack.
    Vec3 opening = Vec3::Zero();
    /// Mean unit normal of the triangles along it, by the lengths of its edges.
    Vec3 rim = Vec3::Zero();

    /// 1 for a hole in a flat surface, 0 for the end of a tube, negative where the surface turns inwards.
    double flatness() const { return rim.dot(opening.stableNormalized()); }
};

/// The borders of a mesh as it is indexed, in the order of their lowest vertices.
std::vector<BorderLoop> border_loops(const TriangleMesh& mesh);

/// Volume that a closed surface encloses, in cubed units of the mesh: positive if the normals point outwards.
/// The number means nothing for a surface that isn't closed.
double enclosed_volume(const TriangleMesh& mesh);

} // namespace wm3d
