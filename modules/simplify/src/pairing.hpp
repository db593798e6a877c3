// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Which half-edges lie on the same edge.
#pragma once

#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::simplify {

/// Partner of each half-edge (3 f + k runs from corner k to corner k + 1).
struct Pairing {
    std::vector<Index> partner; ///< 3 #F: the other half-edge of an edge of two triangles, else no_index
    std::vector<bool> complex;  ///< #V: end of an edge of three or more triangles
    bool oriented = true;       ///< partners run in opposite directions everywhere
};

Pairing pair_half_edges(const std::vector<Triangle>& triangles, std::size_t vertices);

/// Turns triangles over so that partners run in opposite directions wherever that is possible; in each
/// component connected by pairs, the triangles of the larger area keep their side.
void orient(std::vector<Triangle>& triangles, const std::vector<Vec3>& positions, const Pairing& pairing);

} // namespace wm3d::simplify
