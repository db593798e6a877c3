// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Dense meshes, made sparser block by block before all of them is simplified.
#pragma once

#include <cstddef>
#include <vector>

#include "canonical.hpp"
#include "sites.hpp"

namespace wm3d::simplify {

struct Options;

/// What thinning did.
struct Thinning {
    std::vector<Standing> standing; ///< of the vertices of thinned blocks, ascending
    double largest_error = 0;       ///< mean squared distance, as Decimator has it
    std::size_t removed = 0;        ///< vertices
};

/// Vertices of one block, about: a block's working set fits a processor's cache.
inline constexpr std::size_t usual_block = 1u << 15;

/// Removes vertices by half-edge collapses within blocks of consecutive vertices of the curve, all blocks at the same
/// time. Vertices with a neighbour in another block stay, and so do blocks that aren't consistently oriented
/// manifolds. Each block keeps two times its share of the target by number, or four times its share of what the
/// surface needs if that is more: of an even error a vertex of area A and turn a of the normals around it needs
/// (a A)^(2/3), since the error of removing vertices at a distance l from a surface of curvature k grows as k^2 l^6.
/// \param input  becomes the thinned mesh
Thinning thin(Canonical& input, const Options& options, std::size_t block = usual_block);

/// The same with what `thin` left in a few large blocks, of which each keeps but 1.2 times its share by number, or 1.6 times
/// that by need: little is left then to be removed in one thread.
/// \param thinning  what `thin` returned; becomes what both did
void thin_further(Canonical& input, const Options& options, Thinning& thinning);

} // namespace wm3d::simplify
