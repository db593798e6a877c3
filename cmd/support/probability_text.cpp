// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/probability_text.hpp"

#include <cmath>

#include <fmt/format.h>

namespace wm3d::cmd {

std::string power_of_ten(double log10_p) {
    if (std::isnan(log10_p))
        return "not defined";
    if (std::isinf(log10_p))
        return "0";
    if (log10_p > -4)
        return fmt::format("{:.2g}", std::pow(10, log10_p));
    const double exponent = std::floor(log10_p);
    return fmt::format("{:.1f}e{:.0f}", std::pow(10, log10_p - exponent), exponent);
}

} // namespace wm3d::cmd
