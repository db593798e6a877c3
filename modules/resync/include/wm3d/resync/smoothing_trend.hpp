// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Where the canonical frame was before a mesh was smoothed.
#pragma once

#include <vector>

#include <wm3d/mesh/frame.hpp>
#include <wm3d/resync/candidate_pose.hpp>

namespace wm3d::resync {

/// Smoothing shrinks ears and legs first, so it turns and moves the canonical frame; more of it goes on in
/// the same direction.
struct TrendOptions {
    int steps = 20;      ///< of the umbrella operator that show the direction
    double weight = 0.1; ///< of a step
    /// How far to go back, in multiples of what those steps change: as it wanes, 3 undoes 50 steps.
    std::vector<double> back{1.6, 3.0};
    std::size_t most_vertices = 200000; ///< on denser meshes so few steps change nothing
    double least_turn = 0.3;            ///< of a frame that is worth trying, in degrees
    double least_shift = 0.003;         ///< or move of its centre, in mean radii
};

/// Frames that the mesh had if it was smoothed, each where it differs enough from `frame`: `frame` less
/// multiples of what further smoothing does to it. Depends on the mesh alone.
/// \param frame  canonical frame of the mesh, of this substance
std::vector<CandidatePose> frames_before_smoothing(const TriangleMesh& mesh, const Frame& frame,
                                                   Substance substance, const TrendOptions& options = {});

} // namespace wm3d::resync
