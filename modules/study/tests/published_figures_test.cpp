// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/study/published_figures.hpp>

#include <string>
#include <vector>

#include <doctest/doctest.h>

#include <wm3d/study/bench.hpp>

using namespace wm3d;
using namespace wm3d::study;

TEST_CASE("bit error rates of 64 bits have the false-positive probabilities of the binomial distribution") {
    // math.log10(sum(math.comb(64, k) for k in range(b + 1)) / 2**64) of Python for b = 0, 5, 8, 13 errors
    CHECK(log10_false_positive(0) == doctest::Approx(-19.265919722494797).epsilon(1e-12));
    CHECK(log10_false_positive(0.078) == doctest::Approx(-12.34665157630605).epsilon(1e-12));
    CHECK(log10_false_positive(0.125) == doctest::Approx(-9.555746523993037).epsilon(1e-12));
    CHECK(log10_false_positive(0.203) == doctest::Approx(-6.02664993771021).epsilon(1e-12));
    CHECK(log10_false_positive(1) == doctest::Approx(0));
    CHECK(published_rates("noise:0.5", Protocol::geometric)->wang == 0.40);
    CHECK(published_rates("noise:0.5", Protocol::perceptual)->cho == 0.28);
    CHECK_FALSE(published_rates("bend:5", Protocol::geometric));
}

TEST_CASE("every attack with published figures is one of the default list") {
    std::vector<std::string> names;
    for (const AttackChain& chain : default_attacks())
        names.push_back(attack::to_string(chain));
    std::size_t published = 0;
    for (const std::string& name : names)
        published += published_rates(name, Protocol::geometric).has_value();
    CHECK(published == 18);
}
