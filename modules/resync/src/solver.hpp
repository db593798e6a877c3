// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The least-squares step of iterative closest points.
#pragma once

#include <span>

#include <wm3d/resync/similarity.hpp>

#include "point_to_plane.hpp"

namespace wm3d::resync {

/// The similarity near `start` that takes the points to their planes, under Tukey's biweight: a point farther
/// from its plane than `loss_width` has no say.
Similarity solve(std::span<const PointToPlane> terms, const Similarity& start, double loss_width);

} // namespace wm3d::resync
