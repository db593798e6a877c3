// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/payload/uncoded.hpp>

#include <cmath>

#include <doctest/doctest.h>

#include <wm3d/payload/sequence.hpp>

#include "channel.hpp"
#include "support.hpp"

using namespace wm3d;
using namespace wm3d::payload;
using payload::test::rmax;

namespace {

constexpr unsigned level = 4;

/// Of many marks that score `sigmas`, the share of payload bits that are decided wrong.
double error_rate(const char* text, double sigmas, std::uint64_t trials) {
    const Message message = parse_message(text);
    std::size_t bits = 0, errors = 0;
    for (std::uint64_t trial = 0; trial < trials; ++trial) {
        const key::Secret secret = key::null_secret(8, trial);
        const Content content{message, {}};
        const auto statistic =
            test::noisy(mark_sequence(secret, level, rmax, content, {0}), rmax, sigmas, trial);
        const UncodedErrors found = uncoded_errors(secret, level, message, statistic.coefficients());
        bits += found.bits;
        errors += found.errors;
    }
    return static_cast<double>(errors) / static_cast<double>(bits);
}

/// Of bits that are sent over additive normal noise, each `distance` deviations from the decision.
double normal_error_rate(double distance) {
    return std::erfc(distance / std::sqrt(2.0)) / 2;
}

} // namespace

TEST_CASE("without a code each bit has its part of the score, and errs as one that was sent alone") {
    // A score of 12 deviations gives each of 64 bits 12 / sqrt(64), of 32 bits 12 / sqrt(32).
    CHECK(error_rate("0x0123456789abcdef", 12, 60) == doctest::Approx(normal_error_rate(1.5)).epsilon(0.15));
    CHECK(error_rate("0x01234567", 12, 60) ==
          doctest::Approx(normal_error_rate(12 / std::sqrt(32.0))).epsilon(0.4));
    CHECK(error_rate("0x0123456789abcdef", 40, 4) == 0);
    CHECK(error_rate("0x0123456789abcdef", 0, 60) == doctest::Approx(0.5).epsilon(0.06));
}

TEST_CASE("a bit that nothing is said about counts as wrong") {
    const std::vector<double> nothing(key::sequence_length(level), 0.0);
    const UncodedErrors found =
        uncoded_errors(key::null_secret(8, 1), level, parse_message("0x0123456789abcdef"), nothing);
    CHECK(found.bits == 64);
    CHECK(found.errors == 64);
}
