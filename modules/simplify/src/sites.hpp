// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  What the simplification stores of each vertex beside its half-edges.
#pragma once

#include <array>
#include <span>
#include <vector>

#include "candidate_queue.hpp"
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
    std::vector<CostKey> key;     ///< #W: not above the cost of any of its choices; no_cost: never removed

    /// Where what is known of v lies; most processors send the line behind a quadric's first as well.
    std::array<const void*, 2> places(Index v) const { return {&site[v], &quadric[v].xx}; }
};

/// What a vertex stands for already.
struct Standing {
    Index vertex; ///< number in the thinned mesh
    Quadric quadric;
    double constant; ///< of the quadric at the vertex
};

/// Area-weighted plane quadrics, isotropic quadrics and boundary planes, gathered per vertex in the order of
/// its ring.
/// \param positions  of the input; let go before the quadrics take their place
/// \param standing   what some vertices begin with in place of that, ascending
/// \param first      vertex of the first site
Sites build_sites(const Surface& surface, std::vector<Vec3> positions, const Options& options,
                  std::span<const Standing> standing = {}, std::size_t first = 0);

} // namespace wm3d::simplify
