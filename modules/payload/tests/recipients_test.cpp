// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/payload/recipients.hpp>

#include <algorithm>
#include <cmath>
#include <string_view>

#include <fmt/format.h>

#include <doctest/doctest.h>
#include <wm3d/core/parallel.hpp>
#include <wm3d/detect/tail.hpp>
#include <wm3d/key/stream.hpp>

#include "channel.hpp"
#include "frozen_sequence.hpp"
#include "support.hpp"

using namespace wm3d;
using namespace wm3d::payload;
using payload::test::rmax;

namespace {

const key::Secret issuer = key::null_secret(4, 1);

std::vector<std::uint64_t> buyers(std::size_t count, unsigned level) {
    std::vector<std::uint64_t> numbers;
    for (std::size_t r = 0; r < count; ++r)
        numbers.push_back(copy_number("work", fmt::format("buyer {}", r), level));
    return numbers;
}

/// Mean of the sequences of some copies.
std::vector<double> average(std::span<const std::uint64_t> numbers, unsigned level) {
    std::vector<double> mean(key::sequence_length(level), 0.0);
    for (const std::uint64_t number : numbers) {
        const std::vector<double> one = copy_sequence(issuer, level, rmax, number);
        for (std::size_t j = 0; j < mean.size(); ++j)
            mean[j] += one[j] / static_cast<double>(numbers.size());
    }
    return mean;
}

} // namespace

TEST_CASE("scores are those of the sequences, at any number of threads") {
    for (const unsigned level : {0u, 1u, 4u}) {
        const std::vector<std::uint64_t> numbers = buyers(200, level);
        const auto statistic = test::noisy(copy_sequence(issuer, level, rmax, numbers[3]), rmax, 3, 1);
        const detect::LinearStatistic signs(
            {statistic.coefficients().begin(), statistic.coefficients().end()}, rmax / std::sqrt(3.0),
            detect::Law::sign);
        const std::vector<double> scores = copy_scores(issuer, statistic, numbers);
        for (std::size_t r = 0; r < numbers.size(); r += 17)
            CHECK(scores[r] == doctest::Approx(signs.value(copy_sequence(issuer, level, rmax, numbers[r])) /
                                               signs.sigma()));
        const ThreadLimit one_thread(1);
        CHECK(copy_scores(issuer, statistic, numbers) == scores);
    }
}

TEST_CASE("the right one of a thousand is accused, and nobody else") {
    const std::vector<std::uint64_t> numbers = buyers(1000, 4);
    for (const std::size_t guilty : {0u, 500u, 999u}) {
        const auto statistic = test::noisy(copy_sequence(issuer, 4, rmax, numbers[guilty]), rmax, 9, guilty);
        const std::vector<Accusation> accused =
            accuse(statistic, copy_scores(issuer, statistic, numbers), -6, numbers.size());
        REQUIRE(accused.size() == 1);
        CHECK(accused[0].copy == guilty);
        CHECK(accused[0].log10_p < -8);
        CHECK(accused[0].sigmas == doctest::Approx(9).epsilon(0.3));
    }
}

TEST_CASE("the scores of innocent copies are distributed as the exact tail says") {
    const std::vector<std::uint64_t> numbers = buyers(20000, 3);
    const auto statistic = test::noisy(average(std::span(numbers).first(2), 3), rmax, 12, 5);
    const std::vector<double> scores = copy_scores(issuer, statistic, numbers);
    const detect::LinearStatistic signs({statistic.coefficients().begin(), statistic.coefficients().end()}, 1,
                                        detect::Law::sign);
    for (const double z : {1.0, 2.0, 3.0}) {
        const double p = std::pow(10, detect::exact_tail(signs, z * signs.sigma()).log10_p);
        const double expected = p * 19998;
        const auto reached =
            std::count_if(scores.begin() + 2, scores.end(), [&](double s) { return s >= z; });
        CHECK(std::abs(static_cast<double>(reached) - expected) < 4 * std::sqrt(expected));
    }
}

TEST_CASE("of copies that were averaged each is accused as long as its part shows") {
    const std::vector<std::uint64_t> numbers = buyers(1000, 5);
    for (const std::size_t colluders : {2u, 3u, 5u}) {
        // Each scores as the whole mark over the number of them.
        const auto statistic =
            test::noisy(average(std::span(numbers).first(colluders), 5), rmax, 40, colluders);
        const std::vector<Accusation> accused =
            accuse(statistic, copy_scores(issuer, statistic, numbers), -6, numbers.size());
        CHECK(accused.size() >= 1);
        CHECK(std::ranges::all_of(accused, [&](const Accusation& a) { return a.copy < colluders; }));
    }
}

TEST_CASE("the sequence of a copy is that of the independent generator") {
    const std::vector<double> sequence =
        copy_sequence(key::null_secret(3, 1), 3, 0.3, copy_number("work", "Ann", 3));
    for (std::size_t j = 0; j < std::string_view(frozen_copy).size(); ++j)
        CHECK((sequence[j] > 0) == (frozen_copy[j] == '+'));
}

TEST_CASE("names, works and levels give different numbers, the same ones the same") {
    CHECK(copy_number("w", "a", 5) == copy_number("w", "a", 5));
    CHECK(copy_number("w", "a", 5) != copy_number("w", "b", 5));
    CHECK(copy_number("w", "a", 5) != copy_number("v", "a", 5));
    CHECK(copy_number("w", "a", 5) != copy_number("w", "a", 4));
}

TEST_CASE("a suspect that says nothing accuses nobody") {
    const detect::LinearStatistic nothing(std::vector<double>(key::sequence_length(2), 0.0), rmax);
    const std::vector<double> scores = copy_scores(issuer, nothing, buyers(5, 2));
    CHECK(std::ranges::all_of(scores, [](double s) { return s == 0; }));
    CHECK(accuse(nothing, scores, -6, 5).empty());
}
