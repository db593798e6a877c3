// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  What eq. (4) to (6) take from a mesh.
#pragma once

#include <wm3d/detect/paper.hpp>

namespace wm3d::pipeline {

/// Moments of a base mesh and of the bumps above it.
struct MeshStatistics {
    detect::PaperStatistics paper;
    unsigned level = 0;          ///< of the watermarking sphere
    double null_sigma_ratio = 1; ///< standard deviation of rho over random keys, over the one that eq. (6) assumes
};

} // namespace wm3d::pipeline
