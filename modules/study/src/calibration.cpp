// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/study/calibration.hpp>

#include <cmath>
#include <mutex>

#include <fmt/format.h>

#include <wm3d/core/parallel.hpp>
#include <wm3d/detect/tail.hpp>

namespace wm3d::study {

namespace {

using Counts = std::vector<std::vector<std::size_t>>; // statistics by probabilities

/// The paper's rho against eq. (6), which looks at the moments of the key's own bumps.
struct PaperRule {
    std::vector<double> radii;
    sphere::SparseRows rows;
    std::vector<double>
        unit_thresholds; ///< per probability: T_rho for unit variances and mean 0, times sqrt(n)

    void count(std::span<const double> w, std::vector<std::size_t>& passed) const {
        const detect::PaperStatistics s = detect::paper_statistics(radii, sphere::multiply(rows, w));
        const double spread = std::sqrt(s.sigma_r2 * s.delta_mean_square);
        for (std::size_t k = 0; k < passed.size(); ++k)
            passed[k] += s.rho > spread * unit_thresholds[k] + s.mu_r * s.delta_mean;
    }
};

PaperRule paper_rule(const watermark::Examination& suspect, unsigned level, const std::vector<double>& pf) {
    PaperRule rule{suspect.radii(), suspect.rows(0, level), {}};
    for (double p : pf)
        rule.unit_thresholds.push_back(detect::threshold(p, rule.radii.size(), 1, 1, 0, 0));
    return rule;
}

/// What P_f the paper's thresholds have for a key whose bumps have the expected mean square.
TailCounts paper_expectation(const watermark::Examination& suspect, unsigned level,
                             const std::vector<double>& pf) {
    TailCounts counts{"paper, eq. (6)", {}, {}};
    watermark::Sequences sequences(key::null_secret(0, 0), suspect.options().rmax);
    const std::vector<double> radii = suspect.radii();
    const sphere::SparseRows rows = suspect.rows(0, level);
    const auto statistics = detect::paper_statistics(radii, sphere::multiply(rows, sequences(level)));
    const auto linear = detect::paper_statistic(radii, rows, suspect.options().rmax);
    for (double p : pf)
        counts.expected_pf.push_back(std::pow(10, detect::log10_true_pf(linear, statistics, p)));
    return counts;
}

} // namespace

Calibration calibrate(const watermark::Examination& suspect, unsigned level, std::size_t keys,
                      std::uint64_t seed, const std::vector<double>& pf) {
    Calibration result{keys, pf, {}};
    std::vector<detect::LinearStatistic> statistics;
    std::vector<std::vector<double>> thresholds;
    const sphere::SparseRows rows = suspect.rows(0, level);
    for (std::size_t f = 0; f < suspect.evidence().filters(); ++f) {
        statistics.push_back(suspect.evidence().statistic(f, rows, suspect.options().rmax));
        result.counts.push_back({"whitened, " + detect::describe(suspect.evidence().filter(f)), pf, {}});
        thresholds.emplace_back();
        for (double p : pf)
            thresholds.back().push_back(detect::tail_quantile(statistics.back(), std::log10(p)));
    }
    result.counts.push_back(paper_expectation(suspect, level, pf));
    const PaperRule paper = paper_rule(suspect, level, pf);

    Counts total(result.counts.size(), std::vector<std::size_t>(pf.size(), 0));
    std::mutex guard; // sums of whole numbers: their order doesn't matter
    parallel_blocks(keys, 256, [&](std::size_t begin, std::size_t end) {
        Counts own(total.size(), std::vector<std::size_t>(pf.size(), 0));
        for (std::size_t k = begin; k < end; ++k) {
            const std::vector<double> w =
                key::watermark_sequence(key::null_secret(seed, k), level, suspect.options().rmax);
            for (std::size_t s = 0; s < statistics.size(); ++s) {
                const double value = statistics[s].value(w);
                for (std::size_t i = 0; i < pf.size(); ++i)
                    own[s][i] += value >= thresholds[s][i];
            }
            paper.count(w, own.back());
        }
        const std::lock_guard lock(guard);
        for (std::size_t s = 0; s < total.size(); ++s)
            for (std::size_t i = 0; i < pf.size(); ++i)
                total[s][i] += own[s][i];
    });
    for (std::size_t s = 0; s < total.size(); ++s)
        result.counts[s].passed = total[s];
    return result;
}

} // namespace wm3d::study
