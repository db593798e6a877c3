// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/study/mesh_analysis.hpp>
#include <wm3d/study/recommend.hpp>

#include <array>
#include <cmath>
#include <numeric>

#include <doctest/doctest.h>

#include <wm3d/shapes/sample.hpp>

using namespace wm3d;
using namespace wm3d::study;

namespace {

constexpr std::uint64_t seed = 1, another_seed = 4;

std::vector<std::size_t> first_numbers(std::size_t count) {
    std::vector<std::size_t> numbers(count);
    std::iota(numbers.begin(), numbers.end(), 0);
    return numbers;
}

TrialSetting small_setting() {
    TrialSetting setting;
    setting.level = 4;
    setting.parameters.levels = {4};
    return setting;
}

} // namespace

TEST_CASE("what is predicted of the marks that mark makes by default is what trials count") {
    const TriangleMesh mesh = shapes::sample(4000, 1);
    const TrialBench bench(mesh, small_setting());
    const MeshStatistics statistics = mesh_statistics(bench, key::null_secret(seed, 0));
    const std::array pf{1e-6, 1e-4, 1e-2};
    constexpr double visibility = 0.1; // here P_m goes from nearly 1 to nearly 0
    const std::vector<RocCurve> predicted = predicted_rocs(bench, statistics, visibility, pf, 60);
    REQUIRE(predicted.size() == 1); // the paper's model knows no such marks
    CHECK(predicted.front().visibility == visibility);

    const std::vector<Trial> trials = run_trials(bench, visibility, another_seed, first_numbers(50));
    const MeasuredCurve measured = measured_roc(RocKind::whitened, trials, bench, visibility, pf);
    for (std::size_t i = 0; i < pf.size(); ++i) {
        CAPTURE(pf[i]);
        const MeasuredPoint counted =
            measured_point(pf[i], measured.points[i].missed, trials.size(), 0.99); // three at once
        CHECK(predicted.front().points[i].pm >= counted.low);
        CHECK(predicted.front().points[i].pm <= counted.high);
    }
    CHECK(measured.points.front().missed > 0); // so that the intervals say something
    CHECK(measured.points.back().missed < trials.size());
}

TEST_CASE("a visibility that is seen over a wide range of strengths is kept to as well") {
    // With this key a mark may be more than three times as strong for a tenth more of MSDM2.
    const TriangleMesh mesh = shapes::sample(4000, 1);
    const TrialBench bench(mesh, small_setting());
    constexpr std::size_t number = 62;
    const watermark::Marked marked = bench.mark(0.11, another_seed, number);
    REQUIRE(marked.msdm2);
    CHECK(*marked.msdm2 <= 0.11);
    CHECK(*marked.msdm2 > 0.1);
    CHECK(marked.strength > 3 * bench.mark(0.1, another_seed, number).strength);
}

TEST_CASE("the mark that is recommended is the least visible one that does") {
    const TriangleMesh mesh = shapes::sample(4000, 1);
    Requirement requirement;
    requirement.pf = 1e-6;
    requirement.pm = 0.05;
    requirement.pilots = 6;
    const Recommendation advice = recommend(mesh, small_setting(), requirement);
    REQUIRE(advice.reached);
    CHECK(advice.sizing == Sizing::visibility);
    REQUIRE(advice.outcomes.size() == 1);
    CHECK(advice.outcomes.front().log10_pm <= std::log10(requirement.pm));

    const TrialBench bench(mesh, small_setting());
    const std::array pf{requirement.pf};
    const auto missed = [&](double size) {
        return measured_roc(RocKind::whitened, run_trials(bench, size, seed, first_numbers(20)), bench, size,
                            pf)
            .points.front();
    };
    CHECK(missed(advice.size).low <= requirement.pm);
    CHECK(missed(0.7 * advice.size).low > requirement.pm);
}

TEST_CASE("a size that nothing reaches is told as such") {
    Requirement requirement;
    requirement.pf = 1e-300;
    requirement.pilots = 2;
    const Recommendation advice = recommend(shapes::sample(2000, 1), small_setting(), requirement);
    CHECK_FALSE(advice.reached);
    CHECK(largest_size(Sizing::visibility) == "0.5");
    CHECK(largest_size(best_sizing(watermark::Profile::robust)) == "2 %");
}
