// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  ROC curves of a mesh, predicted: the paper's, the paper's in truth, the deciding detector's.
#pragma once

#include <span>
#include <vector>

#include <wm3d/detect/paper.hpp>
#include <wm3d/study/paper_roc.hpp>
#include <wm3d/study/response.hpp>
#include <wm3d/study/trials.hpp>

namespace wm3d::study {

/// Moments of a base mesh and of the bumps above it.
struct MeshStatistics {
    detect::PaperStatistics paper;
    unsigned level = 0; ///< of the watermarking sphere
    double null_sigma_ratio =
        1; ///< standard deviation of rho over random keys, over the one that eq. (6) assumes
};

/// What eq. (4) to (6) take from the bench's base with the bumps of `secret`, in the frame of the mark.
MeshStatistics mesh_statistics(const TrialBench& bench, const key::Secret& secret);

/// The detectors whose curves belong to marks of a profile: the paper's model knows no other marks than its
/// own, and the deciding detector decides on all.
std::vector<RocKind> detectors_for(watermark::Profile profile);

/// The predicted curves for marks of one size; the deciding detector's from `pilots` marks (see Response),
/// its gamma their mean. The paper's only for its own profile and without damage, of which they know nothing.
std::vector<RocCurve> predicted_rocs(const TrialBench& bench, const MeshStatistics& statistics, double size,
                                     std::span<const double> pf, std::size_t pilots,
                                     const Progress& progress = {});

} // namespace wm3d::study
