// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The input in an order that its geometry alone decides.
#pragma once

#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::simplify {

/// Vertices along a Morton curve, triangles by their corners; no isolated vertices, no repeated triangles.
struct Canonical {
    std::vector<Vec3> positions;     ///< centred; largest side of the box scaled to 1
    std::vector<Triangle> triangles; ///< the smallest corner first, orientation as in the input
    std::vector<Index> input_vertex; ///< number of each vertex in the input
    double scale = 1;                ///< units of the input per unit of `positions`
};

/// \throw GeometryError  for an index out of range or a coordinate that isn't finite
Canonical canonical_order(const TriangleMesh& mesh);

} // namespace wm3d::simplify
