// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/watermark/content_statistic.hpp>

#include <cmath>
#include <vector>

#include <doctest/doctest.h>

#include <wm3d/key/stream.hpp>

using namespace wm3d;
using namespace wm3d::watermark;

namespace {

constexpr unsigned level = 4;
constexpr double rmax = 0.1;

/// Uniform numbers of mean square 1.
std::vector<double> numbers(std::uint64_t which) {
    std::vector<double> values(key::sequence_length(level));
    key::Stream(key::null_secret(31, which), key::Purpose::trial, 0).fill_symmetric(values, std::sqrt(3.0));
    return values;
}

/// What a filter sees of a mark, `strength` for each number, under noise of its own and noise that all filters share.
detect::Hypothesis seen(double strength, std::span<const double> mark, std::uint64_t noise,
                        std::size_t filter, std::size_t pose = 0) {
    const std::vector<double> own = numbers(noise), shared = numbers(1000);
    std::vector<double> c(mark.size());
    for (std::size_t j = 0; j < c.size(); ++j)
        c[j] = strength * mark[j] + own[j] + shared[j];
    return {detect::LinearStatistic(std::move(c), rmax), level, pose, filter};
}

double sigmas(const detect::LinearStatistic& statistic, std::span<const double> sequence) {
    return statistic.value(sequence) / statistic.sigma();
}

/// A mark of a common part and content of the same energy.
struct Mark {
    std::vector<double> common = numbers(1), content = numbers(2), both = common;
    Mark() {
        for (std::size_t j = 0; j < both.size(); ++j)
            both[j] += content[j];
    }
};

} // namespace

TEST_CASE("filters of one pose together say more about the content than the best of them") {
    const Mark mark;
    std::vector<double> scaled = mark.content;
    for (double& x : scaled)
        x *= rmax / std::sqrt(3.0);
    const std::vector<detect::Hypothesis> family{seen(0.2, mark.both, 11, 0), seen(0.25, mark.both, 12, 1),
                                                 seen(0.2, mark.both, 13, 2)};
    const detect::LinearStatistic blend = content_statistic(family, 1, mark.common);
    CHECK(sigmas(blend, scaled) > 1.05 * sigmas(family[1].statistic, scaled));
    CHECK(blend.rmax() == rmax);

    // Whoever wears another key's content is told nothing by the choice of weights.
    const std::vector<double> other = numbers(3);
    CHECK(std::abs(sigmas(blend, other)) * rmax / std::sqrt(3.0) < 4);
}

TEST_CASE("other poses and levels, and filters that see nothing, have no part in it") {
    const Mark mark;
    std::vector<detect::Hypothesis> family{seen(0.2, mark.both, 11, 0), seen(0.2, mark.both, 12, 1)};
    const detect::LinearStatistic two = content_statistic(family, 0, mark.common);
    family.push_back(seen(0.9, mark.both, 13, 0, 1));
    family.push_back(
        {detect::LinearStatistic(std::vector<double>(key::sequence_length(level)), rmax), level, 0, 2});
    family.push_back(
        {detect::LinearStatistic(std::vector<double>(key::sequence_length(3), 1.0), rmax), 3, 0, 0});
    const detect::LinearStatistic again = content_statistic(family, 0, mark.common);
    CHECK(std::vector(two.coefficients().begin(), two.coefficients().end()) ==
          std::vector(again.coefficients().begin(), again.coefficients().end()));
    const detect::LinearStatistic alone = content_statistic(family, 2, mark.common);
    CHECK(alone.coefficients()[0] == family[2].statistic.coefficients()[0]);
}

TEST_CASE("the same filter twice is the filter, and a suspect that says nothing stays silent") {
    const Mark mark;
    const detect::Hypothesis once = seen(0.3, mark.both, 11, 0);
    const detect::LinearStatistic twice = content_statistic(std::vector{once, once}, 0, mark.common);
    const double ratio = twice.coefficients()[0] / once.statistic.coefficients()[0];
    CHECK(twice.coefficients()[7] == doctest::Approx(ratio * once.statistic.coefficients()[7]));
    const detect::Hypothesis nothing{
        detect::LinearStatistic(std::vector<double>(key::sequence_length(level)), rmax), level, 0, 0};
    CHECK(content_statistic(std::vector{nothing, nothing}, 0, mark.common).sigma() == 0);
}
