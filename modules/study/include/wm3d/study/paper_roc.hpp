// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Curves of the paper's detector: eq. (5) and (6), and what they are worth on a mesh.
#pragma once

#include <span>

#include <wm3d/detect/linear_statistic.hpp>
#include <wm3d/detect/paper.hpp>
#include <wm3d/study/roc.hpp>

namespace wm3d::study {

/// The quantities of eq. (5) and (6) when no mesh is at hand (figure 8 of the paper).
struct PaperModel {
    double sigma_r2 = 0;    ///< variance of the radii
    double delta_range = 0; ///< Delta is uniform in [-delta_range, delta_range]
};

/// Eq. (5) and (6) over P_f.
RocCurve paper_roc(const PaperModel& model, double gamma, std::size_t vertices, std::span<const double> pf);

/// Eq. (5) and (6) with the moments of a mesh and a key.
RocCurve paper_roc(const detect::PaperStatistics& statistics, double gamma, std::span<const double> pf);

/// The paper's detector as it truly behaves on the mesh: the threshold is set so that a random key passes
/// with probability P_f, by the exact null distribution of `null` (detect::paper_statistic), and the mark
/// adds gamma (mean(Delta^2) - mean(Delta)^2) to it, eq. (3) in eq. (4).
RocCurve true_paper_roc(const detect::PaperStatistics& statistics, const detect::LinearStatistic& null,
                        double gamma, std::span<const double> pf);

} // namespace wm3d::study
