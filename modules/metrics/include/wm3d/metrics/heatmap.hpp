// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Colours for a value at each vertex.
#pragma once

#include <array>
#include <cstdint>
#include <span>
#include <vector>

namespace wm3d::metrics {

using Rgb = std::array<std::uint8_t, 3>;

/// Dark violet at 0 over blue, green to yellow at 1, of evenly rising lightness and legible to the
/// colour-blind, in the manner of the map known as viridis. Values outside [0, 1] take the end's colour, NaN
/// the first.
Rgb heat_colour(double value);

/// Colours of values from 0 to `top`; 0 for `top` means the largest value.
std::vector<Rgb> heat_colours(std::span<const double> values, double top = 0);

} // namespace wm3d::metrics
