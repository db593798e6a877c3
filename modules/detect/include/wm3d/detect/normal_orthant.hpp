// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The probability that several correlated scores all stay below their thresholds.
#pragma once

#include <Eigen/Core>

namespace wm3d::detect {

/// log10 P(Z_1 <= limit_1, ..., Z_n <= limit_n) for normal Z of the given mean (n) and covariance (n by n),
/// also where it underflows. Exact for n = 1; for more, A. Genz' transformation ("Numerical computation of
/// multivariate normal probabilities", J. Comp. Graph. Stat. 1, 1992) over a fixed lattice: about four digits
/// of the probability.
/// \pre  n > 0; the covariance is symmetric and positive semidefinite with a positive diagonal
double log10_normal_orthant(const Eigen::VectorXd& mean, const Eigen::MatrixXd& covariance,
                            const Eigen::VectorXd& limit);

} // namespace wm3d::detect
