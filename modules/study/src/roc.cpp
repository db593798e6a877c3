// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/study/roc.hpp>

#include <boost/math/distributions/binomial.hpp>

namespace wm3d::study {

std::string_view name(RocKind kind) {
    switch (kind) {
    case RocKind::paper:
        return "paper";
    case RocKind::paper_true:
        return "paper-true";
    default:
        return "whitened";
    }
}

MeasuredPoint measured_point(double pf, std::size_t missed, std::size_t trials, double confidence) {
    using Binomial = boost::math::binomial_distribution<>;
    const auto n = static_cast<double>(trials), k = static_cast<double>(missed);
    const double side = (1 - confidence) / 2;
    MeasuredPoint point;
    point.pf = pf;
    point.missed = missed;
    point.pm = k / n;
    point.low = missed == 0 ? 0 : Binomial::find_lower_bound_on_p(n, k, side);
    point.high = missed == trials ? 1 : Binomial::find_upper_bound_on_p(n, k, side);
    return point;
}

} // namespace wm3d::study
