// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Wigner's d functions, upwards in degree, which is the stable direction.
#pragma once

#include <algorithm>
#include <cmath>

namespace wm3d::search {

/// log n!. std::lgamma would do, but for the sign, which it writes where all threads do.
inline double log_factorial(unsigned n) {
    int sign = 0;
    return ::lgamma_r(n + 1.0, &sign);
}

/// Calls visit(l, d^l_mn(beta)) for l = max(m, n) to bandwidth - 1, ascending; beta between 0 and pi.
/// \pre  m >= n >= 0
template<typename Visit>
void wigner_d(unsigned bandwidth, unsigned m, unsigned n, double beta, Visit&& visit) {
    // d^m_mn = sqrt((2m)! / ((m + n)! (m - n)!)) cos(beta/2)^(m + n) (-sin(beta/2))^(m - n), by logarithms:
    // far from the equator it underflows to a harmless zero.
    const double log_first = 0.5 * (log_factorial(2 * m) - log_factorial(m + n) - log_factorial(m - n)) +
                             (m + n) * std::log(std::cos(beta / 2)) + (m - n) * std::log(std::sin(beta / 2));
    double before = 0, current = ((m - n) % 2 == 0 ? 1 : -1) * std::exp(log_first);
    const double cosine = std::cos(beta), mn = static_cast<double>(m) * n;
    const auto root = [&](double l) { return std::sqrt((l * l - 1.0 * m * m) * (l * l - 1.0 * n * n)); };
    for (unsigned l = m; l < bandwidth; ++l) {
        visit(l, current);
        const double next_root = root(l + 1.0);
        double next = (l + 1) * (2.0 * l + 1) * (cosine - (l == 0 ? 0 : mn / (l * (l + 1.0)))) * current;
        if (l > m)
            next -= (l + 1.0) / l * root(l) * before;
        before = current;
        current = next / next_root;
    }
}

} // namespace wm3d::search
