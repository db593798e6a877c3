// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Making one vertex of positions that coincide.
#pragma once

#include <span>
#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d {

struct Welded {
    TriangleMesh mesh;            ///< one vertex per distinct position, numbered by first appearance
    std::vector<Index> vertex_of; ///< #input vertices: their vertex of `mesh`
};

/// Merges vertices whose three coordinates are equal (-0 equals 0) and drops triangles that then repeat a
/// corner. Later triangles that repeat an earlier one's three corners are kept: that is topology, not seams.
Welded weld(std::span<const Vec3> positions, std::span<const Triangle> triangles);

/// The same in the memory of what is given.
Welded weld(std::vector<Vec3>&& positions, std::vector<Triangle>&& triangles);

} // namespace wm3d
