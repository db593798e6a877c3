// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  A channel for tests: what a suspect says is what was embedded, plus noise.
#pragma once

#include <cmath>
#include <cstdint>
#include <span>
#include <vector>

#include <wm3d/detect/linear_statistic.hpp>
#include <wm3d/key/stream.hpp>

namespace wm3d::payload::test {

/// Coefficients in which a sequence of root mean square rmax / sqrt(3) scores about `sigmas` standard
/// deviations over random keys. Noise is a sum of four uniform numbers.
inline detect::LinearStatistic noisy(std::span<const double> sequence, double rmax, double sigmas,
                                     std::uint64_t noise) {
    std::vector<double> c(sequence.size(), 0.0), part(sequence.size());
    key::Stream stream(key::null_secret(99, noise), key::Purpose::trial, 0);
    for (int k = 0; k < 4; ++k) {
        stream.fill_symmetric(part);
        for (std::size_t j = 0; j < c.size(); ++j)
            c[j] += part[j] * std::sqrt(3.0 / 4);
    }
    const double n = static_cast<double>(c.size());
    // Of n coefficients of deviation 1, the part along the sequence is sigmas: the rest keeps what is left of
    // n.
    const double along = sigmas / std::sqrt(n) / (rmax / std::sqrt(3.0));
    const double rest = std::sqrt(std::max(1 - sigmas * sigmas / n, 0.0));
    for (std::size_t j = 0; j < c.size(); ++j)
        c[j] = rest * c[j] + along * sequence[j];
    return {std::move(c), rmax};
}

} // namespace wm3d::payload::test
