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

double normal_sigmas(double log10_p) {
    return std::numbers::sqrt2 * boost::math::erfc_inv(2 * std::pow(10.0, std::max(log10_p, -300.0)));
}

double most_sigmas(std::size_t vertices, double chance) {
    return std::sqrt(static_cast<double>(vertices)) + std::sqrt(2 * std::log(1 / chance));
}

double predicted_miss(double sigmas, double log10_pf, std::size_t hypotheses) {
    const double log10_share =
        log10_pf - std::log10(static_cast<double>(std::max<std::size_t>(hypotheses, 1)));
    return 0.5 * std::erfc((sigmas - normal_sigmas(log10_share)) / std::numbers::sqrt2);
}

Verdict decide(double log10_p, double log10_pf, double predicted_miss, double tolerated_miss) {
    if (log10_p <= log10_pf)
        return Verdict::present;
    return predicted_miss <= tolerated_miss ? Verdict::absent : Verdict::inconclusive;
}

} // namespace wm3d::detect
