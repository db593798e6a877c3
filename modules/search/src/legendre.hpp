// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Normalised associated Legendre functions, upwards in degree, which is the stable direction.
#pragma once

#include <cmath>
#include <numbers>

namespace wm3d::search {

/// Calls visit(l, m, P) for 0 <= m <= l < bandwidth, ascending in l for each m, with P exp(i m phi) =
/// Y_lm(theta, phi).
template<typename Visit>
void legendre(unsigned bandwidth, double cosine, double sine, Visit&& visit) {
    double diagonal = std::sqrt(0.25 / std::numbers::pi); // P_mm
    for (unsigned m = 0; m < bandwidth; ++m) {
        if (m > 0)
            diagonal *= -std::sqrt((2.0 * m + 1) / (2.0 * m)) * sine;
        double before = 0, current = diagonal, b = 0;
        visit(m, m, current);
        for (unsigned l = m + 1; l < bandwidth; ++l) {
            const double a2 = (4.0 * l * l - 1) / (static_cast<double>(l - m) * (l + m));
            const double a = std::sqrt(a2);
            const double next = a * (cosine * current - b * before);
            b = 1 / a; // sqrt((l^2 - m^2) / (4 l^2 - 1)), for the next degree
            before = current;
            current = next;
            visit(l, m, current);
        }
    }
}

} // namespace wm3d::search
