// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/payload/carrier.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>
#include <string_view>

#include <doctest/doctest.h>
#include <wm3d/core/error.hpp>

#include "frozen_sequence.hpp"

using namespace wm3d;
using namespace wm3d::payload;

namespace {

const key::Secret carrier_secret = key::null_secret(3, 1);

double dot(const std::vector<double>& a, const std::vector<double>& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

} // namespace

TEST_CASE("what is modulated is demodulated, and every coded bit has its share of the vertices") {
    for (const unsigned level : {3u, 5u}) {
        const Carrier carrier(carrier_secret, level, Format::bits64);
        std::vector<std::uint8_t> coded(512);
        for (std::size_t k = 0; k < coded.size(); ++k)
            coded[k] = k % 3 == 0;
        const std::vector<double> sequence = carrier.modulated(coded, 0.25);
        CHECK(sequence.size() == key::sequence_length(level));
        CHECK(std::ranges::all_of(sequence, [](double v) { return std::abs(v) == 0.25; }));
        const std::vector<double> soft = carrier.demodulated(sequence);
        const std::size_t share = key::sequence_length(level) / coded.size(); // of each bit, at least
        const double least = 0.25 * static_cast<double>(share);
        for (std::size_t k = 0; k < coded.size(); ++k) {
            CHECK((soft[k] < 0) == (coded[k] == 1));
            CHECK(std::abs(soft[k]) >= doctest::Approx(least));
            CHECK(std::abs(soft[k]) <= doctest::Approx(least + 0.25));
        }
    }
}

TEST_CASE("carriers of other keys, levels, formats and of the watermark itself have nothing in common") {
    const Message message = parse_message("0x1234");
    const std::vector<double> one = payload_sequence(carrier_secret, 5, 0.1, message);
    const double norm = dot(one, one);
    CHECK(norm / static_cast<double>(one.size()) == doctest::Approx(0.01 / 3)); // that of uniform numbers
    const std::vector<std::vector<double>> others{
        payload_sequence(key::null_secret(3, 2), 5, 0.1, message),
        payload_sequence(carrier_secret, 5, 0.1, parse_message("12345678")),
        payload_sequence(carrier_secret, 5, 0.1, parse_message("123456789")),
        key::watermark_sequence(carrier_secret, 5, 0.1)};
    for (const std::vector<double>& other : others)
        CHECK(std::abs(dot(one, other)) < 5 / std::sqrt(static_cast<double>(one.size())) * norm);
    CHECK_THROWS_AS(Carrier(carrier_secret, key::max_level + 1, Format::bits64), ParameterError);
}

TEST_CASE("the sequence of a message is that of the independent generator") {
    const std::vector<double> sequence = payload_sequence(carrier_secret, 3, 0.3, parse_message("frozen"));
    for (std::size_t j = 0; j < std::string_view(frozen_payload).size(); ++j)
        CHECK((sequence[j] > 0) == (frozen_payload[j] == '+'));
}
