// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Rough poses of a part of a surface, from pairs of oriented points that look alike.
#pragma once

#include <vector>

#include <wm3d/resync/similarity.hpp>

#include "point_index.hpp"

namespace wm3d::resync {

struct PairOptions {
    std::size_t points = 260;       ///< of either side that form pairs
    std::size_t hypotheses = 12000; ///< poses to score, those of the rarest pairs first
    std::size_t keep = 32;          ///< best distinct poses to return
    double least_scale = 0.3;       ///< of the part's unit over the whole's
    double most_scale = 1.15;
};

/// Transforms from the part's coordinates to the whole's, the most promising first. Both are in units of
/// their own mean radius. The angles between two normals and the line from one point to the other don't
/// depend on scale; the distance of the points then tells it.
std::vector<Similarity> pair_starts(const PointIndex& whole, const PointIndex& part,
                                    const PairOptions& options);

/// How well the whole explains the part in a pose: 1 if all of its points lie on it. Every `stride`-th point
/// counts.
double explained(const PointIndex& whole, const PoseTemplate& part, const Similarity& pose, double tolerance,
                 std::size_t stride = 1);

} // namespace wm3d::resync
