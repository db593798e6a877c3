// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  P(T >= t) over random keys for a linear statistic, to any depth.
#pragma once

#include <wm3d/detect/linear_statistic.hpp>

namespace wm3d::detect {

/// log10 P(T >= t) and how far it can be trusted.
struct Tail {
    double log10_p = 0;
    /// Estimated relative error of p. Where `bound` is true, p is not an estimate but an upper bound.
    double relative_error = 0;
    bool bound = false;
};

/// The probability itself, by integrating the moment generating function along the vertical line through the
/// saddlepoint (Bromwich integral, trapezoidal rule; the error is estimated by halving the step). Accurate to
/// about ten digits for statistics of many terms. Falls back to `chernoff_bound` where the integral doesn't
/// settle, as it can for a statistic of very few terms.
Tail exact_tail(const LinearStatistic& statistic, double t);

/// Lugannani and Rice's saddlepoint approximation: log10 P(T >= t). Thirty times faster than `exact_tail`;
/// the calibration tests measure its error.
double saddlepoint_log10_tail(const LinearStatistic& statistic, double t);

/// Chernoff's guaranteed upper bound min_s exp(K(s) - s t): log10.
double chernoff_log10_bound(const LinearStatistic& statistic, double t);

/// The t with P(T >= t) = 10^log10_pf, by the saddlepoint approximation.
/// \pre  -300 < log10_pf < 0 and sigma > 0
double tail_quantile(const LinearStatistic& statistic, double log10_pf);

} // namespace wm3d::detect
