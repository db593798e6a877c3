// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/detect/family.hpp>

#include <algorithm>
#include <cmath>

#include <wm3d/core/error.hpp>
#include <wm3d/detect/tail.hpp>

namespace wm3d::detect {

namespace {

/// Hypotheses whose p is computed: in sigmas the order is almost that of p.
constexpr std::size_t finalists = 3;

Score raw_score(const Hypothesis& hypothesis, std::size_t number, const SequenceOfLevel& sequence) {
    Score score;
    score.hypothesis = number;
    score.value = hypothesis.statistic.value(sequence(hypothesis.level));
    const double sigma = hypothesis.statistic.sigma();
    score.sigmas = sigma > 0 ? score.value / sigma : 0;
    return score;
}

} // namespace

FamilyScore score_family(std::span<const Hypothesis> family, const SequenceOfLevel& sequence) {
    if (family.empty())
        throw ParameterError(
            "there is no hypothesis to score: allow at least one pose, one level and one filter");
    std::vector<Score> scores;
    scores.reserve(family.size());
    for (std::size_t h = 0; h < family.size(); ++h)
        scores.push_back(raw_score(family[h], h, sequence));
    const auto middle = scores.begin() + static_cast<std::ptrdiff_t>(std::min(finalists, scores.size()));
    std::partial_sort(scores.begin(), middle, scores.end(), [](const Score& a, const Score& b) {
        return a.sigmas != b.sigmas ? a.sigmas > b.sigmas : a.hypothesis < b.hypothesis;
    });

    for (auto s = scores.begin(); s != middle; ++s)
        s->log10_p = saddlepoint_log10_tail(family[s->hypothesis].statistic, s->value);
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
    std::vector<double> thresholds;
    thresholds.reserve(family.size());
    for (const Hypothesis& h : family)
        thresholds.push_back(h.statistic.sigma() > 0 ? tail_quantile(h.statistic, log10_share) : 0);
    return thresholds;
}

bool reaches(std::span<const Hypothesis> family, std::span<const double> thresholds,
             const SequenceOfLevel& sequence) {
    for (std::size_t h = 0; h < family.size(); ++h)
        if (family[h].statistic.sigma() > 0 &&
            family[h].statistic.value(sequence(family[h].level)) >= thresholds[h])
            return true;
    return false;
}

} // namespace wm3d::detect
