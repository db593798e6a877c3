// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/detect/verdict.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <boost/math/special_functions/erf.hpp>

namespace wm3d::detect {

std::string_view name(Verdict verdict) {
    switch (verdict) {
    case Verdict::present:
        return "present";
    case Verdict::absent:
        return "absent";
    default:
        return "inconclusive";
    }
}

double predicted_miss(double sigmas, double log10_pf, std::size_t hypotheses) {
    const double log10_share =
        log10_pf - std::log10(static_cast<double>(std::max<std::size_t>(hypotheses, 1)));
    const double needed =
        std::numbers::sqrt2 * boost::math::erfc_inv(2 * std::pow(10.0, std::max(log10_share, -300.0)));
    return 0.5 * std::erfc((sigmas - needed) / std::numbers::sqrt2);
}

Verdict decide(double log10_p, double log10_pf, double predicted_miss, double tolerated_miss) {
    if (log10_p <= log10_pf)
        return Verdict::present;
    return predicted_miss <= tolerated_miss ? Verdict::absent : Verdict::inconclusive;
}

} // namespace wm3d::detect
