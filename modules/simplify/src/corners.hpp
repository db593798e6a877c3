// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The triangles of each vertex.
#pragma once

#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::simplify {

/// Corners (3 f + k) grouped by vertex: those of v are corners[start[v]] up to corners[start[v + 1]].
struct Corners {
    std::vector<Index> start, corners;
};

Corners corners_by_vertex(const std::vector<Triangle>& triangles, std::size_t vertices);

} // namespace wm3d::simplify
