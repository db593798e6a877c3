// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  What the paper's threshold truly does on a mesh.
#pragma once

#include <span>

#include <wm3d/detect/linear_statistic.hpp>
#include <wm3d/detect/paper.hpp>
#include <wm3d/sphere/sparse_rows.hpp>

namespace wm3d::detect {

/// The part of eq. (4) that decides against eq. (6), as a linear statistic: rho - mu_r mean(Delta) =
/// sum_j c_j w_j with c = B^T (r - mu_r) / n. It holds for Delta = B w, the linear form of the bumps.
LinearStatistic paper_statistic(std::span<const double> radius, const sphere::SparseRows& rows, double rmax);

/// The false-positive probability, over random keys, that a threshold of eq. (6) for `pf` truly has on this
/// mesh: P(rho - mu_r mean(Delta) > sqrt(2 sigma_r^2 mean(Delta^2) / n) erfc^-1(2 P_f)), with mean(Delta^2)
/// held at the key's own value (it varies by about a percent between keys). log10.
double log10_true_pf(const LinearStatistic& statistic, const PaperStatistics& paper, double pf);

} // namespace wm3d::detect
