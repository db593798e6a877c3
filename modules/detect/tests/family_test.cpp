// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/detect/family.hpp>

#include <cmath>
#include <memory>

#include <doctest/doctest.h>

#include <wm3d/core/error.hpp>
#include <wm3d/detect/tail.hpp>

using namespace wm3d;
using namespace wm3d::detect;

namespace {

double pseudo_random(std::uint64_t& state) {
    state = state * 6364136223846793005u + 1442695040888963407u;
    return static_cast<double>(state >> 11) * 0x1p-52 - 1;
}

std::vector<double> random_numbers(std::size_t n, std::uint64_t seed, double scale = 1) {
    std::vector<double> x(n);
    for (double& v : x)
        v = scale * pseudo_random(seed);
    return x;
}

std::vector<Hypothesis> some_family() {
    std::vector<Hypothesis> family;
    for (std::size_t h = 0; h < 6; ++h)
        family.push_back({LinearStatistic(random_numbers(400, 11 * h + 1), 0.1), 2, h, 0});
    return family;
}

} // namespace

TEST_CASE("the planted hypothesis wins, and all of them are paid for") {
    const std::vector<Hypothesis> family = some_family();
    std::vector<double> w = random_numbers(400, 99, 0.05);
    for (std::size_t j = 0; j < w.size(); ++j)
        w[j] += 0.05 * std::copysign(1.0, family[4].statistic.coefficients()[j]) * 0.9;
    const FamilyScore score = score_family(family, [&](unsigned) { return std::span<const double>(w); });
    CHECK(score.best.hypothesis == 4);
    CHECK(score.hypotheses == 6);
    CHECK(score.log10_p == doctest::Approx(score.best.log10_p + std::log10(6.0)));
    CHECK(score.best.log10_p == exact_tail(family[4].statistic, family[4].statistic.value(w)).log10_p);
    CHECK(score.log10_p < -6);
}

TEST_CASE("a turned hypothesis scores as its statistic in the sequence's own order") {
    std::vector<Hypothesis> family = some_family();
    auto turn = std::make_shared<std::vector<Index>>(400);
    for (Index j = 0; j < 400; ++j)
        (*turn)[j] = (j + 17) % 400; // no involution, so that the two ways to apply it differ
    family[2].turn = turn;
    const std::vector<double> w = random_numbers(400, 5, 0.1);
    const LinearStatistic own = own_statistic(family[2]);
    CHECK(own.coefficients()[17] == family[2].statistic.coefficients()[0]);
    const auto sequence = [&](unsigned) { return std::span<const double>(w); };
    const FamilyScore score = score_family(std::span(family).subspan(2, 1), sequence);
    CHECK(score.best.value == doctest::Approx(own.value(w)));
    CHECK(score.best.sigmas == doctest::Approx(own.value(w) / own.sigma()));
    const std::vector<double> below{own.value(w) - 1e-6}, above{own.value(w) + 1e-6};
    CHECK(reaches(std::span(family).subspan(2, 1), below, sequence));
    CHECK_FALSE(reaches(std::span(family).subspan(2, 1), above, sequence));
}

TEST_CASE("the family's false-positive probability holds") {
    const std::vector<Hypothesis> family = some_family();
    const double pf = 0.05;
    const std::vector<double> thresholds = family_thresholds(family, pf);
    int positives = 0, by_score = 0;
    constexpr int keys = 4000;
    for (std::uint64_t k = 0; k < keys; ++k) {
        const std::vector<double> w = random_numbers(400, 1000 + 7919 * k, 0.1);
        const auto sequence = [&](unsigned) { return std::span<const double>(w); };
        const bool positive = reaches(family, thresholds, sequence);
        positives += positive;
        if (k < 500)
            by_score += positive == (score_family(family, sequence).log10_p <= std::log10(pf));
    }
    CHECK(positives < keys * pf + 4 * std::sqrt(keys * pf));
    CHECK(positives > keys * pf * 0.6); // Bonferroni on almost independent hypotheses gives little away
    CHECK(by_score == 500);
}

TEST_CASE("no hypothesis and senseless probabilities are refused") {
    CHECK_THROWS_AS(score_family({}, {}), ParameterError);
    const std::vector<Hypothesis> family = some_family();
    CHECK_THROWS_AS(family_thresholds(family, 0), ParameterError);
    CHECK_THROWS_AS(family_thresholds(family, 1), ParameterError);
}
