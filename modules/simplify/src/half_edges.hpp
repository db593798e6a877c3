// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Compact half-edges: three per triangle, numbered 3 f + k, so that next and previous need no
/// storage.
#pragma once

#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::simplify {

struct HalfEdge {
    Index origin = no_index; ///< vertex it leaves
    Index twin = no_index;   ///< the same edge in the neighbouring triangle; no_index at a boundary
};

inline Index next(Index h) {
    return h % 3 == 2 ? h - 2 : h + 1;
}
inline Index previous(Index h) {
    return h % 3 == 0 ? h + 2 : h - 1;
}

/// A manifold surface: its half-edges, and per vertex one that leaves it.
struct HalfEdges {
    std::vector<HalfEdge> edges; ///< 3 #F
    std::vector<Index> leaving;  ///< #W; at a boundary vertex the one without twin, so that turning
                                 ///< counter-clockwise from it meets all triangles of the vertex
    std::vector<Index> source;   ///< #W: the vertex of the input it is, or is a copy of
    std::vector<bool> locked;    ///< #W: the surface isn't a manifold here, the vertex must stay

    Index target(Index h) const { return edges[next(h)].origin; }
    /// The next half-edge counter-clockwise around the same origin; no_index at the boundary.
    Index turn(Index h) const { return edges[previous(h)].twin; }
};

/// Builds the half-edges of any mesh, as `build_surface` describes.
HalfEdges build_half_edges(std::vector<Triangle> triangles, const std::vector<Vec3>& positions);

} // namespace wm3d::simplify
