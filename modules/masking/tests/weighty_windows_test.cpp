// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/masking/weighty_windows.hpp>

#include <cmath>
#include <vector>

#include <doctest/doctest.h>

using namespace wm3d;
using masking::WeightyWindows;

namespace {

double minkowski(const std::vector<double>& local) {
    double sum = 0;
    for (double x : local)
        sum += x * x * x;
    return std::cbrt(sum / static_cast<double>(local.size()));
}

/// Local distances of very different sizes.
metrics::Msdm2Sample sample(std::size_t count) {
    metrics::Msdm2Sample all;
    for (std::size_t i = 0; i < count; ++i) {
        all.vertices.push_back(static_cast<Index>(2 * i));
        all.local.push_back(0.02 + 0.2 * std::pow(std::sin(0.37 * static_cast<double>(i)), 8));
    }
    all.mean = minkowski(all.local);
    return all;
}

/// What the windows at some vertices of a sample have become.
std::vector<double> at(const std::vector<Index>& vertices, const std::vector<double>& local) {
    std::vector<double> some;
    for (Index v : vertices)
        some.push_back(local[v / 2]);
    return some;
}

} // namespace

TEST_CASE("few windows follow the mean of all as the distances grow, alike or unalike") {
    const metrics::Msdm2Sample all = sample(20'000);
    const WeightyWindows windows(all, 500);
    CHECK(windows.vertices().size() <= 500);
    CHECK(windows.vertices().size() > 400);
    CHECK(windows.mean(at(windows.vertices(), all.local)) == doctest::Approx(all.mean));
    std::vector<double> twice = all.local, uneven = all.local;
    for (double& x : twice)
        x *= 2;
    CHECK(windows.mean(at(windows.vertices(), twice)) == doctest::Approx(2 * all.mean));
    for (std::size_t i = 0; i < uneven.size(); ++i)
        uneven[i] *= 1 + 0.5 * std::cos(1e-3 * static_cast<double>(i));
    CHECK(windows.mean(at(windows.vertices(), uneven)) == doctest::Approx(minkowski(uneven)).epsilon(5e-3));
}

TEST_CASE("a window that outweighs all others stands for many shares") {
    metrics::Msdm2Sample all = sample(1000);
    all.local[77] = 2;
    all.mean = minkowski(all.local);
    const WeightyWindows windows(all, 100);
    CHECK(windows.vertices().size() < 100);
    std::vector<double> calmer = all.local;
    calmer[77] = 1;
    CHECK(windows.mean(at(windows.vertices(), calmer)) == doctest::Approx(minkowski(calmer)).epsilon(0.02));
}

TEST_CASE("some of the windows follow on from where all of them came to") {
    const metrics::Msdm2Sample all = sample(20'000);
    const WeightyWindows windows(all, 500);
    std::vector<double> uneven = all.local, later = all.local;
    for (std::size_t i = 0; i < uneven.size(); ++i) {
        uneven[i] *= 1 + 0.5 * std::cos(1e-3 * static_cast<double>(i));
        later[i] = 1.1 * uneven[i];
    }
    const std::vector<double> now = at(windows.vertices(), uneven);
    const WeightyWindows some = windows.followed_on(now, 4);
    CHECK(some.vertices().size() == doctest::Approx(windows.vertices().size() / 4.0).epsilon(0.02));
    CHECK(some.mean(at(some.vertices(), uneven)) == doctest::Approx(windows.mean(now)));
    CHECK(some.mean(at(some.vertices(), later)) == doctest::Approx(1.1 * windows.mean(now)));
}
