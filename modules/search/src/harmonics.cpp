// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/search/harmonics.hpp>

#include <cmath>

#include "legendre.hpp"

namespace wm3d::search {

std::vector<double> Harmonics::power() const {
    std::vector<double> result(bandwidth);
    for (unsigned l = 0; l < bandwidth; ++l)
        for (unsigned m = 0; m <= l; ++m)
            result[l] += (m == 0 ? 1 : 2) * std::norm((*this)(l, m));
    return result;
}

Harmonics Harmonics::inverted() const {
    Harmonics result = *this;
    for (unsigned l = 1; l < bandwidth; l += 2)
        for (unsigned m = 0; m <= l; ++m)
            result(l, m) = -result(l, m);
    return result;
}

Harmonics Harmonics::weighted(std::span<const double> factors) const {
    Harmonics result = *this;
    for (unsigned l = 0; l < bandwidth; ++l)
        for (unsigned m = 0; m <= l; ++m)
            result(l, m) *= factors[l];
    return result;
}

Harmonics direct_harmonics(std::span<const Vec3> directions, std::span<const double> q, unsigned bandwidth) {
    Harmonics f(bandwidth);
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const Vec3 d = directions[i].normalized();
        const double sine = std::hypot(d.x(), d.y());
        const std::complex<double> turn =
            sine > 0 ? std::complex(d.x() / sine, -d.y() / sine) : std::complex(1.0, 0.0);
        std::vector<std::complex<double>> phase(bandwidth, q[i]);
        for (unsigned m = 1; m < bandwidth; ++m)
            phase[m] = phase[m - 1] * turn;
        legendre(bandwidth, d.z(), sine, [&](unsigned l, unsigned m, double p) { f(l, m) += p * phase[m]; });
    }
    return f;
}

double evaluate(const Harmonics& f, const Vec3& direction) {
    const Vec3 d = direction.normalized();
    const double sine = std::hypot(d.x(), d.y()), phi = std::atan2(d.y(), d.x());
    double sum = 0;
    legendre(f.bandwidth, d.z(), sine, [&](unsigned l, unsigned m, double p) {
        sum += (m == 0 ? 1 : 2) * p * (f(l, m) * std::polar(1.0, m * phi)).real();
    });
    return sum;
}

} // namespace wm3d::search
