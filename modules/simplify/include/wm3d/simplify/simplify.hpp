// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Quadric simplification of any triangle mesh to a given number of vertices.
#pragma once

#include <cstddef>
#include <string_view>
#include <vector>

#include <wm3d/core/progress.hpp>
#include <wm3d/mesh/triangle_mesh.hpp>
#include <wm3d/simplify/observer.hpp>

namespace wm3d::simplify {

struct Options {
    /// Vertices of the base mesh at which to stop.
    std::size_t target_vertices = 10000;
    /// Weight of the planes that hold the boundary in place, relative to the surface's own planes.
    double boundary_weight = 10.0;
    /// Weight of an isotropic quadric beside each plane. It decides between collapses that cost nothing (flat
    /// regions) in favour of short edges, by geometry and not by file order.
    double isotropy = 1e-4;
    /// A triangle may not turn by more than this in one collapse, in degrees, 0 to 90.
    double max_normal_turn = 75.0;
    /// Meshes of so many vertices, and of eight times the target, are thinned block by block first, where no observer
    /// looks on.
    std::size_t thinned_from = 200'000;
};

/// Why the simplification ended.
enum class Stop {
    reached,       ///< the base mesh has exactly the target number of vertices
    already_small, ///< the input has no more vertices than the target: nothing was removed
    blocked,       ///< no collapse is left that keeps topology, boundaries and normals
};

/// One sentence for people.
std::string_view describe(Stop stop);

struct Result {
    TriangleMesh mesh;           ///< the base mesh, consistently oriented where the input can be
    std::vector<Index> original; ///< #base vertices: their numbers in the input
    Stop stop = Stop::reached;
    double error = 0; ///< largest root mean square distance, in units of the mesh, of a kept vertex
                      ///< from the planes it stands for (boundary planes included)
    std::size_t collapses = 0;
};

/// Simplifies `mesh` by half-edge collapses, always the one of least quadric error (M. Garland, P. Heckbert,
/// "Surface simplification using quadric error metrics", SIGGRAPH 1997, quadrics weighted by area; a base
/// vertex is a vertex of the input at its own position). This is the simplification of the paper's
/// section 2.1. Dense meshes are first thinned in blocks of a space-filling curve, each in this order, down to some four
/// times what its surface needs of the target; quadrics go on.
///
/// Any mesh is accepted. Triangles that repeat a corner or that repeat the corners of another triangle are
/// left out; isolated vertices are neither counted nor kept. Vertices where the surface is not a manifold
/// (edges of three or more triangles, several fans, seams that can't be oriented) are kept. Boundary vertices
/// move only along the boundary. Every component, every boundary loop and every handle stays: a component
/// ends as a tetrahedron or a triangle at the smallest.
///
/// The result doesn't depend on the order of vertices and triangles in the input, nor on its scale or place:
/// ties are decided by position. Vertices and triangles of the base mesh follow a space-filling curve.
///
/// \throw GeometryError   if a triangle names a vertex that isn't there, or a used coordinate isn't finite
/// \throw ParameterError  if an option is out of range
Result simplify(const TriangleMesh& mesh, const Options& options, const Progress& progress = {});

/// The same, with every collapse told to `observer` as it happens.
Result simplify(const TriangleMesh& mesh, const Options& options, Observer& observer,
                const Progress& progress = {});

} // namespace wm3d::simplify
