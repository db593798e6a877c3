// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  From triangles to the manifold surface that is simplified.
#pragma once

#include <cstddef>
#include <optional>
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

/// The rings of the first `wanted` vertices of a mesh, if it is a consistently oriented manifold there, which is known by
/// looking at one vertex at a time; the others have empty ones. Nothing if it is not, or if a vertex has very many
/// triangles.
std::optional<Rings> rings_of_manifold(const std::vector<Triangle>& triangles, std::size_t vertices,
                                       std::size_t wanted);

} // namespace wm3d::simplify
