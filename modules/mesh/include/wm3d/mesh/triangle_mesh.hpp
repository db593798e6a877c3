// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The triangle mesh (K, V) of the paper's section 1.1, as two arrays.
#pragma once

#include <vector>

#include <wm3d/mesh/types.hpp>

namespace wm3d {

/// An indexed triangle mesh. Nothing is promised about its topology: non-manifold edges, boundaries,
/// several components and isolated vertices are all normal. Functions state what more they need.
struct TriangleMesh {
    std::vector<Vec3> positions;     ///< #V
    std::vector<Triangle> triangles; ///< #F by 3, indices into `positions`
};

/// The point of `mesh` that `point` names: the sum of its barycentric coordinates times the corners.
/// \pre  point.triangle < #F
inline Vec3 evaluate(const TriangleMesh& mesh, const SurfacePoint& point) {
    const Triangle& t = mesh.triangles[point.triangle];
    return point.barycentric[0] * mesh.positions[t[0]] + point.barycentric[1] * mesh.positions[t[1]] +
           point.barycentric[2] * mesh.positions[t[2]];
}

} // namespace wm3d
