// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/study/published_figures.hpp>

#include <algorithm>
#include <array>
#include <cmath>

namespace wm3d::study {

namespace {

struct Row {
    std::string_view attack;
    PublishedRates perceptual, geometric;
};

constexpr std::array rows{
    Row{"file", {0, 0}, {0, 0}},
    Row{"similarity", {0, 0}, {0, 0}},
    Row{"noise:0.05", {0.01, 0}, {0, 0.02}},
    Row{"noise:0.1", {0.03, 0.01}, {0.01, 0.15}},
    Row{"noise:0.3", {0.13, 0.08}, {0.10, 0.29}},
    Row{"noise:0.5", {0.28, 0.16}, {0.24, 0.40}},
    Row{"smoothing:5", {0.10, 0}, {0.06, 0.06}},
    Row{"smoothing:10", {0.23, 0.01}, {0.16, 0.18}},
    Row{"smoothing:30", {0.38, 0.07}, {0.34, 0.39}},
    Row{"smoothing:50", {0.45, 0.14}, {0.42, 0.51}},
    Row{"quantization:11", {0, 0}, {0, 0.01}},
    Row{"quantization:10", {0.04, 0.01}, {0.02, 0.17}},
    Row{"quantization:9", {0.14, 0.01}, {0.06, 0.27}},
    Row{"quantization:8", {0.26, 0.05}, {0.18, 0.39}},
    Row{"quantization:7", {0.46, 0.17}, {0.41, 0.53}},
    Row{"subdivision:midpoint", {0.04, 0}, {0.02, 0}},
    Row{"subdivision:sqrt3", {0.14, 0}, {0.09, 0.01}},
    Row{"subdivision:loop", {0.16, 0}, {0.09, 0.01}},
};

} // namespace

double best_published(const PublishedRates& rates) {
    return std::min(rates.cho, rates.wang);
}

std::optional<PublishedRates> published_rates(std::string_view attack, Protocol protocol) {
    const auto* row = std::ranges::find(rows, attack, &Row::attack);
    if (row == rows.end())
        return {};
    return protocol == Protocol::perceptual ? row->perceptual : row->geometric;
}

double log10_false_positive(double rate) {
    constexpr int bits = 64;
    const long errors = std::lround(rate * bits);
    double ways = 0, choose = 1; // choose = bits! / (k! (bits - k)!)
    for (long k = 0; k <= errors; ++k) {
        ways += choose;
        choose *= static_cast<double>(bits - k) / static_cast<double>(k + 1);
    }
    return std::log10(ways) - bits * std::log10(2.0);
}

} // namespace wm3d::study
