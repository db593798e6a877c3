// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/watermark/null_keys.hpp>

#include <algorithm>
#include <cmath>

#include <wm3d/core/parallel.hpp>
#include <wm3d/detect/tail.hpp>

namespace wm3d::watermark {

double uniformity(std::vector<double> p) {
    if (p.empty())
        return 1;
    std::ranges::sort(p);
    const auto n = static_cast<double>(p.size());
    double distance = 0;
    for (std::size_t i = 0; i < p.size(); ++i)
        distance =
            std::max({distance, p[i] - static_cast<double>(i) / n, static_cast<double>(i + 1) / n - p[i]});
    // Stephens' argument makes the limit distribution accurate for small n.
    const double x = distance * (std::sqrt(n) + 0.12 + 0.11 / std::sqrt(n));
    if (x < 0.2) // the series needs many terms there, and its value is 1 to twelve digits
        return 1;
    double sum = 0;
    for (int k = 1; k <= 100; ++k)
        sum += (k % 2 == 1 ? 2 : -2) * std::exp(-2.0 * k * k * x * x);
    return std::clamp(sum, 0.0, 1.0);
}

NullReport score_null_keys(std::span<const detect::Hypothesis> family, double rmax, double pf,
                           std::size_t keys, std::uint64_t seed, const Progress& progress) {
    constexpr std::size_t block = 16, most_tested = 2000, batch = 1024;
    const std::vector<double> thresholds = detect::family_thresholds(family, pf);
    const detect::Hypothesis& first = family.front();
    std::vector<unsigned char> positive(keys, 0);
    std::vector<double> p(first.statistic.sigma() > 0 ? std::min(keys, most_tested) : 0);
    for (std::size_t start = 0; start < keys; start += batch) {
        notify(progress, "scoring random keys", static_cast<double>(start) / static_cast<double>(keys));
        parallel_blocks(std::min(batch, keys - start), block, [&](std::size_t begin, std::size_t end) {
            for (std::size_t k = start + begin; k < start + end; ++k) {
                Sequences sequences(key::null_secret(seed, k), rmax);
                positive[k] = detect::reaches(family, thresholds, sequences.function());
                if (k < p.size())
                    p[k] =
                        std::pow(10.0, detect::saddlepoint_log10_tail(
                                           first.statistic, first.statistic.value(sequences(first.level))));
            }
        });
    }
    NullReport result;
    result.keys = keys;
    result.false_positives = static_cast<std::size_t>(std::ranges::count(positive, 1));
    result.p_uniformity = uniformity(std::move(p));
    return result;
}

} // namespace wm3d::watermark
