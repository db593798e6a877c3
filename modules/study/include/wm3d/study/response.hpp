// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  How marks show in the deciding detector's scores on a mesh, and the miss probability that follows.
#pragma once

#include <vector>

#include <Eigen/Core>

#include <wm3d/detect/linear_statistic.hpp>
#include <wm3d/study/trials.hpp>

namespace wm3d::study {

/// T = c.w + m over random keys w, per filter of the bank: c.w is the host's part, of which everything is
/// known, and m what the mark itself adds. m grows with the strength and hardly differs between keys, so few
/// marks tell it.
struct Response {
    std::vector<detect::LinearStatistic> host; ///< per filter: c of the (damaged) mesh without a mark
    std::size_t hypotheses = 0;                ///< that share P_f
    std::vector<Eigen::VectorXd> mark;         ///< per mark: m of every filter
    std::vector<Eigen::VectorXd> variance;     ///< per mark: what it adds to the null variance of T
    embed::Distortion distortion;              ///< mean over the marks, % of the box's diagonal
    double gamma = 0;                          ///< of bumps that move as much, mean over the marks
};

/// Marks of random keys that no trial draws, of one size.
/// \throw watermark::TooVisible  if no mark keeps to the visibility
std::vector<watermark::Marked> pilot_marks(const TrialBench& bench, double size, std::size_t count,
                                           const Progress& progress = {});

/// These marks through the real pipeline, with the host's part taken away: it is known for each key. So a few
/// marks say what many would, and what simplification and damage leave of them.
Response pilot_response(const TrialBench& bench, const std::vector<watermark::Marked>& pilots,
                        const Progress& progress = {});

/// log10 of the probability that verify at P_f misses marks whose moves are `factor` times those of the
/// response: none of the filters reaches its threshold. The scores are taken to be jointly normal, with the
/// covariance of c, that of m between keys, and the mean of m; thresholds are those of the exact null
/// distribution. The hypotheses of other poses and levels may only find by chance.
double log10_miss(const Response& response, double factor, double pf);

} // namespace wm3d::study
