// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  What the tests of the detector share.
#pragma once

#include <numeric>
#include <span>

namespace wm3d::detect::test {

/// The largest move of a sphere's vertex, as keys have it unless they say otherwise.
inline constexpr double rmax = 0.1;

inline double dot(std::span<const double> a, std::span<const double> b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

} // namespace wm3d::detect::test
