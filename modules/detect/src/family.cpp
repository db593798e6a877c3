// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/detect/family.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <utility>

#include <wm3d/core/error.hpp>
#include <wm3d/core/parallel.hpp>
#include <wm3d/detect/tail.hpp>

namespace wm3d::detect {

namespace {

/// Hypotheses whose p is computed: in sigmas the order is almost that of p.
constexpr std::size_t finalists = 3;

/// Sequences in the order in which hypotheses count them, each made once.
class CountedSequences {
public:
    explicit CountedSequences(const SequenceOfLevel& sequence) : sequence_(sequence) {}

    std::span<const double> operator()(const Hypothesis& hypothesis) {
        const std::span<const double> w = sequence_(hypothesis.level);
        if (!hypothesis.turn)
            return w;
        const auto [entry, is_new] = turned_.try_emplace({hypothesis.level, hypothesis.turn.get()});
        std::vector<double>& turned = entry->second;
        if (is_new) {
            turned.resize(w.size());
            for (std::size_t j = 0; j < w.size(); ++j)
                turned[j] = w[(*hypothesis.turn)[j]];
        }
        return turned;
    }

private:
    const SequenceOfLevel& sequence_;
    std::map<std::pair<unsigned, const std::vector<Index>*>, std::vector<double>> turned_;
};

Score raw_score(const Hypothesis& hypothesis, std::size_t number, std::span<const double> w) {
    Score score;
    score.hypothesis = number;
    score.value = hypothesis.statistic.value(w);
    const double sigma = hypothesis.statistic.sigma();
    score.sigmas = sigma > 0 ? score.value / sigma : 0;
    return score;
}

/// Of every hypothesis, in their order.
std::vector<Score> raw_scores(std::span<const Hypothesis> family, const SequenceOfLevel& sequence) {
    constexpr std::size_t block = 16;
    CountedSequences counted(sequence);
    std::vector<std::span<const double>> w;
    for (const Hypothesis& h : family)
        w.push_back(counted(h));
    std::vector<Score> scores(family.size());
    parallel_blocks(family.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t h = begin; h < end; ++h)
            scores[h] = raw_score(family[h], h, w[h]);
    });
    return scores;
}

} // namespace

LinearStatistic own_statistic(const Hypothesis& hypothesis) {
    if (!hypothesis.turn)
        return hypothesis.statistic;
    const std::span<const double> c = hypothesis.statistic.coefficients();
    std::vector<double> own(c.size());
    for (std::size_t j = 0; j < c.size(); ++j)
        own[(*hypothesis.turn)[j]] = c[j];
    return {std::move(own), hypothesis.statistic.rmax(), hypothesis.statistic.law()};
}

FamilyScore score_family(std::span<const Hypothesis> family, const SequenceOfLevel& sequence) {
    if (family.empty())
        throw ParameterError(
            "there is no hypothesis to score: allow at least one pose, one level and one filter");
    std::vector<Score> scores = raw_scores(family, sequence);
    const auto middle = scores.begin() + static_cast<std::ptrdiff_t>(std::min(finalists, scores.size()));
    std::partial_sort(scores.begin(), middle, scores.end(), [](const Score& a, const Score& b) {
        return a.sigmas != b.sigmas ? a.sigmas > b.sigmas : a.hypothesis < b.hypothesis;
    });

    parallel_blocks(static_cast<std::size_t>(middle - scores.begin()), 1, [&](std::size_t k, std::size_t) {
        scores[k].log10_p = saddlepoint_log10_tail(family[scores[k].hypothesis].statistic, scores[k].value);
    });
    const Score& best = *std::min_element(
        scores.begin(), middle, [](const Score& a, const Score& b) { return a.log10_p < b.log10_p; });

    FamilyScore result;
    result.best = best;
    result.hypotheses = family.size();
    const Tail tail = exact_tail(family[best.hypothesis].statistic, best.value);
    result.best.log10_p = tail.log10_p;
    result.relative_error = tail.relative_error;
    result.bound = tail.bound;
    result.log10_p = std::min(0.0, tail.log10_p + std::log10(static_cast<double>(family.size())));
    return result;
}

std::vector<double> family_thresholds(std::span<const Hypothesis> family, double pf) {
    if (!(pf > 0 && pf < 1))
        throw ParameterError("the false-positive probability has to lie between 0 and 1, for example 1e-6");
    const double log10_share = std::log10(pf) - std::log10(static_cast<double>(family.size()));
    std::map<const double*, double> of_coefficients; // turned hypotheses share them
    std::vector<double> thresholds;
    thresholds.reserve(family.size());
    for (const Hypothesis& h : family) {
        const auto [entry, is_new] = of_coefficients.try_emplace(h.statistic.coefficients().data(), 0.0);
        if (is_new && h.statistic.sigma() > 0)
            entry->second = tail_quantile(h.statistic, log10_share);
        thresholds.push_back(entry->second);
    }
    return thresholds;
}

bool reaches(std::span<const Hypothesis> family, std::span<const double> thresholds,
             const SequenceOfLevel& sequence) {
    CountedSequences counted(sequence);
    for (std::size_t h = 0; h < family.size(); ++h)
        if (family[h].statistic.sigma() > 0 && family[h].statistic.value(counted(family[h])) >= thresholds[h])
            return true;
    return false;
}

} // namespace wm3d::detect
