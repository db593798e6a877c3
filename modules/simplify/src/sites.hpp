// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  What the simplification stores of each vertex beside its half-edges.
#pragma once

#include <array>
#include <vector>

#include "quadric.hpp"
#include "surface.hpp"

namespace wm3d::simplify {

struct Options;

/// What a neighbour asks of a vertex: half a cache line.
struct Site {
    Vec3 position;
    double constant = 0; ///< the quadric at the vertex itself
};

enum class Kind : unsigned char {
    interior,
    boundary, ///< collapses along the boundary only
    locked,   ///< never removed
};

struct Sites {
    std::vector<Site> site;       ///< #W
    std::vector<Quadric> quadric; ///< #W, each about its vertex
    std::vector<Kind> kind;       ///< #W

    /// Where what is known of v lies.
    std::array<const void*, 3> places(Index v) const { return {&site[v], &quadric[v].xx, &quadric[v].z}; }
};

/// Area-weighted plane quadrics, isotropic quadrics and boundary planes, gathered per vertex in the order of
/// its ring.
/// \param positions  of the input; let go before the quadrics take their place
Sites build_sites(const Surface& surface, std::vector<Vec3> positions, const Options& options);

} // namespace wm3d::simplify
