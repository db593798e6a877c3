// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  What a scene is made of.
#pragma once

#include <cstddef>
#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::watermark {

struct PieceOptions {
    std::size_t most = 8;     ///< pieces, the largest ones
    double least_area = 0.02; ///< of a piece, as a part of the whole surface
    double touch = 0.01; ///< boxes closer than this part of the smaller one's diagonal count as one group
};

/// The parts of a surface that could each be a model of its own: sets of triangles that hang together, and
/// groups of such sets whose boxes touch; largest first, none twice, and never the whole surface. Empty where
/// it is of one piece.
std::vector<TriangleMesh> pieces(const TriangleMesh& mesh, const PieceOptions& options = {});

} // namespace wm3d::watermark
