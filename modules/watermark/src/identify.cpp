// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/watermark/identify.hpp>

#include <algorithm>
#include <cmath>

namespace wm3d::watermark {

IdentifyReport identify(const TriangleMesh& suspect, const key::Key& key, std::span<const IssuedCopy> copies,
                        const VerifyOptions& options, const Progress& progress) {
    IdentifyReport report;
    report.mark = verify(suspect, key, options, progress);
    std::vector<std::uint64_t> numbers;
    std::vector<std::size_t> place; // of each number among the copies
    for (std::size_t k = 0; k < copies.size(); ++k)
        if (copies[k].level == report.mark.level) {
            numbers.push_back(copies[k].number);
            place.push_back(k);
        }
    const std::vector<double> scores =
        payload::copy_scores(key.secret(), report.mark.statistic, numbers, progress);
    report.compared = numbers.size();
    report.best_sigmas = scores.empty() ? 0 : *std::ranges::max_element(scores);
    report.accused = payload::accuse(report.mark.statistic, scores, std::log10(options.pf), copies.size());
    for (payload::Accusation& accusation : report.accused)
        accusation.copy = place[accusation.copy];
    return report;
}

} // namespace wm3d::watermark
