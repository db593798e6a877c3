// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  What a scene, or a cloud of triangles, is made of.
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

/// What of a surface of many parts is looked at.
struct LargestParts {
    TriangleMesh mesh;
    /// Part of the whole surface that is in the mesh and hangs together: a triangle by itself is flat however its
    /// corners were moved, so it can't show a mark.
    double telling = 1;
};

/// The sets of triangles that hang together, the largest first, until they have `most_vertices`; the mesh
/// itself if it has no more. Triangles by themselves stay only where there is nothing else.
LargestParts largest_parts(TriangleMesh mesh, std::size_t most_vertices);

} // namespace wm3d::watermark
