// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/payload/reading.hpp>

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>
#include <wm3d/detect/tail.hpp>
#include <wm3d/payload/carrier.hpp>

#include "channel.hpp"
#include "support.hpp"

using namespace wm3d;
using namespace wm3d::payload;
using payload::test::rmax;

namespace {

/// Messages of a format that are read right at a score, of `trials`; none may be read wrong.
int read_right(const char* text, unsigned level, double sigmas, int trials) {
    const Message message = parse_message(text);
    int right = 0;
    for (int trial = 0; trial < trials; ++trial) {
        const key::Secret secret = key::null_secret(8, static_cast<std::uint64_t>(trial));
        const auto statistic = test::noisy(payload_sequence(secret, level, rmax, message), rmax, sigmas,
                                           static_cast<std::uint64_t>(trial));
        const auto reading = read_payload(secret, level, statistic);
        if (!reading)
            continue;
        const bool is_right = reading->message == message;
        CHECK((is_right || reading->log10_p > -6)); // a wrong one must not be believed
        right += is_right;
    }
    return right;
}

} // namespace

TEST_CASE("64 bits are read at a score of 16, 32 bits at 12, 128 bits at 22") {
    CHECK(read_right("0x0123456789abcdef", 5, 16, 12) == 12);
    CHECK(read_right("0xc0ffee", 5, 12.5, 12) == 12);
    CHECK(read_right("sixteen letters!", 5, 22, 6) == 6);
    CHECK(read_right("0x0123456789abcdef", 4, 17, 12) == 12);
    CHECK(read_right("0x0123456789abcdef", 5, 6, 4) == 0); // beyond what any code could read
}

TEST_CASE("a reading tells score, probability and the errors before decoding") {
    const key::Secret secret = key::null_secret(8, 1);
    const Message message = parse_message("0x0123456789abcdef");
    const auto statistic = test::noisy(payload_sequence(secret, 5, rmax, message), rmax, 20, 4);
    const auto reading = read_payload(secret, 5, statistic);
    REQUIRE(reading);
    CHECK(reading->message == message);
    CHECK(reading->sigmas == doctest::Approx(20).epsilon(0.1));
    const detect::LinearStatistic signs({statistic.coefficients().begin(), statistic.coefficients().end()}, 1,
                                        detect::Law::sign);
    const double alone = detect::exact_tail(signs, reading->sigmas * signs.sigma()).log10_p;
    CHECK(reading->log10_p == doctest::Approx(alone + log10_messages(Format::bits64) + std::log10(3.0)));
    CHECK(reading->coded_bits == 512);
    // 20 sigmas over 512 bits: each is 0.88 deviations from 0, so about 19 % of them show the wrong sign.
    CHECK(reading->coded_errors > 60);
    CHECK(reading->coded_errors < 135);
}

TEST_CASE("no message is believed with other keys, on a marked mesh or on noise") {
    const std::vector<double> marked =
        payload_sequence(key::null_secret(8, 0), 4, rmax, parse_message("0xabcd"));
    int seen = 0;
    for (std::uint64_t k = 1; k <= 60; ++k) {
        const auto statistic = test::noisy(marked, rmax, k % 2 ? 30 : 0, k);
        const auto reading = read_payload(key::null_secret(8, k), 4, statistic, {8});
        if (reading) {
            ++seen;
            CHECK(reading->log10_p > -2);
        }
    }
    CHECK(seen <= 3); // whole frames by chance: 3 formats, 8 candidates, 16 bits of checksum
}

TEST_CASE("the probability of the best of all words is true: few words, random keys") {
    // The bound counts each word; with 2^6 of them and 400 keys on one statistic, p <= 0.1 comes for at most
    // 10 %.
    const PolarCode code(512, 6);
    const auto statistic = test::noisy(std::vector<double>(key::sequence_length(3)), rmax, 0, 7);
    const detect::LinearStatistic signs({statistic.coefficients().begin(), statistic.coefficients().end()}, 1,
                                        detect::Law::sign);
    int below = 0;
    constexpr int keys = 400;
    for (int k = 0; k < keys; ++k) {
        const std::vector<double> soft = soft_values(key::null_secret(11, static_cast<std::uint64_t>(k)), 3,
                                                     Format::bits64, statistic.coefficients());
        double best = -1e300;
        for (unsigned value = 0; value < 64; ++value) {
            std::vector<std::uint8_t> bits;
            for (int b = 5; b >= 0; --b)
                bits.push_back(value >> b & 1);
            const std::vector<std::uint8_t> word = code.encode(bits);
            double t = 0;
            for (std::size_t i = 0; i < soft.size(); ++i)
                t += word[i] ? -soft[i] : soft[i];
            best = std::max(best, t / std::sqrt(512.0));
        }
        below += detect::exact_tail(signs, best * signs.sigma()).log10_p + std::log10(64.0) <= -1;
    }
    CHECK(below <= 0.1 * keys + 3 * std::sqrt(0.09 * keys));
    CHECK(below >= 0.05 * keys); // and it is no loose bound
}

TEST_CASE("a suspect that says nothing has no payload") {
    const std::vector<double> nothing(key::sequence_length(3), 0.0);
    CHECK_FALSE(read_payload(key::null_secret(1, 1), 3, detect::LinearStatistic(nothing, rmax)));
}
