// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Attacks that replace the vertices: subdivision, simplification, remeshing, re-extraction from
/// voxels. All but midpoint subdivision first make an oriented manifold of the mesh (see src/manifold.hpp).
#pragma once

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::attack {

enum class SubdivisionScheme { midpoint, sqrt3, loop };

/// Subdivides `steps` times. Midpoint cuts each triangle in four and keeps the surface; sqrt3 (L. Kobbelt
/// 2000) cuts it in three, Loop (C. Loop 1987) in four, and both smooth; these two by OpenMesh.
/// \throw GeometryError if the result would have more than 50 million triangles
TriangleMesh subdivide(const TriangleMesh& mesh, SubdivisionScheme scheme, int steps);

/// Removes `percent` % of the edges by edge collapses, placed and priced by P. Lindstrom and G. Turk, "Fast
/// and memory efficient polygonal simplification" (1998) without memory of the original; by CGAL. Stops early
/// where no collapse keeps the topology.
/// \pre  0 < percent < 100
TriangleMesh simplify_edges(const TriangleMesh& mesh, double percent);

struct RemeshOptions {
    double factor = 1;  ///< target edge length, in mean edge lengths of the mesh
    int iterations = 3; ///< of splits, collapses, flips, relaxation
};

/// Isotropic remeshing (M. Botsch, L. Kobbelt, "A remeshing approach to multiresolution modeling", 2004) by
/// CGAL: new vertices on the same surface, edges of nearly one length.
TriangleMesh remesh_isotropic(const TriangleMesh& mesh, const RemeshOptions& options = {});

/// Whether this build was made with OpenVDB, and so `extract_voxels`.
bool has_voxels();

/// Turns the surface into a signed distance field with `resolution` voxels across the longest side of its box
/// and extracts the zero level anew, by OpenVDB: the published attack that removes all watermarks that live
/// in the connectivity (arXiv 2311.12059). Holes are closed first, by a fan each.
/// \throw ParameterError if this build lacks OpenVDB, or its library can't be loaded
/// \throw GeometryError if the surface is too thin for the resolution to leave anything
TriangleMesh extract_voxels(const TriangleMesh& mesh, int resolution);

} // namespace wm3d::attack
