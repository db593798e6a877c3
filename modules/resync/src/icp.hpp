// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Iterative closest points, coarse to fine, in two directions.
#pragma once

#include "pair_starts.hpp"
#include "point_index.hpp"
#include "surface_contact.hpp"

namespace wm3d::resync {

/// Refines a rough pose of a part (part -> whole), point to plane of the whole's nearest point, with a loss
/// that narrows from stage to stage.
Similarity refine_on_points(const PointIndex& whole, const PoseTemplate& part, const Similarity& start,
                            std::size_t stride);

struct SurfaceFit {
    Similarity pose;     ///< from the whole's coordinates to the part's
    double residual = 0; ///< root mean square distance of the matched points, in the part's coordinates
    std::size_t matched = 0;
};

/// Refines a good pose (whole -> part) on the part's own surface: exact feet, none on its border, those
/// beyond three robust standard deviations trimmed.
SurfaceFit refine_on_surface(const PoseTemplate& whole, const ContactSurface& part, const Similarity& start,
                             int iterations);

} // namespace wm3d::resync
