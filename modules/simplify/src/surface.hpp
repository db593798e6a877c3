// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  From triangles to the manifold surface that is simplified.
#pragma once

#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>

#include "rings.hpp"

namespace wm3d::simplify {

/// A manifold surface and where it came from.
struct Surface {
    Rings rings;
    std::vector<Index>
        source; ///< #W: the vertex of the input it is, or is a copy of; copies follow all others
    std::vector<bool> locked; ///< #W: the input isn't a manifold here, the vertex must stay
};

/// Orders the triangles around every vertex. Triangles are turned over where neighbours disagree, the larger
/// area of each component deciding. Edges of three or more triangles and seams that can't be oriented are cut
/// open; each fan of triangles around a vertex then becomes a vertex of its own.
/// \pre  no triangle repeats a corner or the corners of another; every vertex has a triangle
Surface build_surface(std::vector<Triangle> triangles, const std::vector<Vec3>& positions);

} // namespace wm3d::simplify
