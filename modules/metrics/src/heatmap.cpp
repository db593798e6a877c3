// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/metrics/heatmap.hpp>

#include <algorithm>
#include <cmath>

namespace wm3d::metrics {

namespace {

/// Stops at equal distances, straight lines between them.
constexpr std::array<Rgb, 10> stops{{{68, 1, 84},
                                     {72, 40, 120},
                                     {62, 74, 137},
                                     {49, 104, 142},
                                     {38, 130, 142},
                                     {31, 158, 137},
                                     {53, 183, 121},
                                     {110, 206, 88},
                                     {181, 222, 43},
                                     {253, 231, 37}}};

} // namespace

Rgb heat_colour(double value) {
    const double last = static_cast<double>(stops.size() - 1);
    const double at = value > 0 ? std::min(value, 1.0) * last : 0; // NaN is not > 0
    const auto low = std::min(static_cast<std::size_t>(at), stops.size() - 2);
    const double share = at - static_cast<double>(low);
    Rgb colour{};
    for (std::size_t k = 0; k < 3; ++k)
        colour[k] =
            static_cast<std::uint8_t>(std::lround((1 - share) * stops[low][k] + share * stops[low + 1][k]));
    return colour;
}

std::vector<Rgb> heat_colours(std::span<const double> values, double top) {
    if (!(top > 0))
        for (double value : values)
            top = std::max(top, value);
    std::vector<Rgb> colours;
    colours.reserve(values.size());
    for (double value : values)
        colours.push_back(heat_colour(top > 0 ? value / top : 0));
    return colours;
}

} // namespace wm3d::metrics
