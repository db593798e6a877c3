// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Edges as their triangles have them.
#pragma once

#include <algorithm>
#include <span>
#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d {

/// An edge as one triangle has it; `forward` if the triangle walks it from low to high.
struct Side {
    Index low, high;
    bool forward;
    Index triangle;
};

/// The sides of all triangles in ascending order, so those of one edge together. In parallel.
std::vector<Side> sorted_sides(const TriangleMesh& mesh);

/// Those of them whose lower ends are among `lows`: of all of a dense mesh at once they take as much memory as the mesh
/// does twice.
/// \param lows  ascending, none twice, all below #V
std::vector<Side> sorted_sides(const TriangleMesh& mesh, std::span<const Index> lows);

/// Calls visit(sides) for every edge with the sides that lie on it, in their order.
/// \param sides  of `sorted_sides`
template<typename Visitor>
void for_each_edge(const std::vector<Side>& sides, Visitor&& visit) {
    for (auto first = sides.begin(); first != sides.end();) {
        const auto last = std::find_if(
            first, sides.end(), [&](const Side& s) { return s.low != first->low || s.high != first->high; });
        visit(std::span<const Side>(first, last));
        first = last;
    }
}

/// The corner of the side's triangle that is no end of it.
inline Index opposite(const TriangleMesh& mesh, const Side& side) {
    const Triangle& t = mesh.triangles[side.triangle];
    return t[0] ^ t[1] ^ t[2] ^ side.low ^ side.high;
}

} // namespace wm3d
