// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The base domain and the place on it of every vertex of the original.
#pragma once

#include <cstddef>
#include <vector>

#include <wm3d/core/progress.hpp>
#include <wm3d/mesh/triangle_mesh.hpp>
#include <wm3d/simplify/simplify.hpp>

namespace wm3d::maps {

struct BaseDomain {
    TriangleMesh mesh;               ///< as `simplify::simplify` makes it
    std::vector<Index> original;     ///< #base vertices: their numbers in the input
    std::vector<SurfacePoint> point; ///< #V of the input: place of each vertex on `mesh`, Pi of the paper; a
                                     ///< vertex without triangle has no place: its `triangle` is no_index
    simplify::Stop stop = simplify::Stop::reached;
    double error = 0; ///< as in simplify::Result
    std::size_t collapses = 0;
    std::size_t relocations = 0; ///< how often a vertex got a place in a new triangle
    std::size_t folded = 0;      ///< those where the fan overlapped itself in the plane
    std::size_t clamped = 0;     ///< those whose point lay in no triangle of the fan
};

/// Simplifies `mesh` and builds the MAPS parameterization along with it (A. Lee, W. Sweldens, P. Schroeder,
/// L. Cowsar, D. Dobkin, "MAPS: Multiresolution adaptive parameterization of surfaces", SIGGRAPH 1998; the
/// paper's section 2.1, equation (1)).
///
/// At each collapse the ring of the removed vertex is flattened by z -> z^a; the removed vertex, and every
/// vertex that had its place in a triangle of the ring, goes to the triangle of the new fan in which it then
/// lies. Where the flattened ring isn't star-shaped about the kept vertex, triangles of the fan are turned
/// over and others overlap (`folded`): of those that keep their orientation the one with the largest smallest
/// coordinate is taken. Negative coordinates become 0 (`clamped`). Vertices of the boundary stay on boundary
/// edges, base vertices stay at their corner exactly. Coordinates are never negative and sum to 1.
///
/// \throw GeometryError, ParameterError  as simplify::simplify
BaseDomain parameterize(const TriangleMesh& mesh, const simplify::Options& options,
                        const Progress& progress = {});

/// Where vertex v of the input lies on the base domain, by equation (1).
/// \pre  v has a place: domain.point[v].triangle != no_index
Vec3 image(const BaseDomain& domain, Index v);

} // namespace wm3d::maps
