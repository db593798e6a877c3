// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/payload/polar_code.hpp>

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>
#include <wm3d/core/error.hpp>
#include <wm3d/key/stream.hpp>

using namespace wm3d;
using namespace wm3d::payload;

namespace {

std::vector<std::uint8_t> random_bits(std::size_t count, std::uint64_t number) {
    std::vector<std::uint64_t> words(count);
    key::Stream(key::null_secret(5, number), key::Purpose::trial, 0).fill(words);
    std::vector<std::uint8_t> bits(count);
    std::ranges::transform(words, bits.begin(), [](std::uint64_t word) { return word >> 63; });
    return bits;
}

std::vector<double> noisy_llr(const std::vector<std::uint8_t>& word, double amplitude, std::uint64_t number) {
    std::vector<double> llr(word.size()), noise(word.size());
    key::Stream stream(key::null_secret(6, number), key::Purpose::trial, 0);
    for (std::size_t k = 0; k < word.size(); ++k)
        llr[k] = word[k] ? -amplitude : amplitude;
    for (int part = 0; part < 4; ++part) {
        stream.fill_symmetric(noise, std::sqrt(3.0 / 4));
        for (std::size_t k = 0; k < word.size(); ++k)
            llr[k] += noise[k];
    }
    for (double& value : llr)
        value *= 2 * amplitude;
    return llr;
}

/// -log of the probability of a word's bits, each given by its LLR.
double cost(const std::vector<std::uint8_t>& word, const std::vector<double>& llr) {
    double sum = 0;
    for (std::size_t k = 0; k < word.size(); ++k)
        sum += std::log1p(std::exp(word[k] ? llr[k] : -llr[k]));
    return sum;
}

} // namespace

TEST_CASE("a code word of length 8 by hand") {
    // Weights of the positions 3, 5, 6, 7 are the greatest; x = u F with F the third power of (1 0; 1 1).
    const PolarCode code(8, 4);
    const std::vector<std::uint8_t> expected{0, 1, 1, 0, 1, 0, 0, 1}; // rows 3, 5, 6 and 7 of F, all added
    CHECK(code.encode(std::vector<std::uint8_t>{1, 1, 1, 1}) == expected);
}

TEST_CASE("without noise every word is read back, at every rate") {
    for (const std::size_t information : {0u, 1u, 17u, 64u, 127u, 128u}) {
        const PolarCode code(128, information);
        const std::vector<std::uint8_t> bits = random_bits(information, information);
        const auto read = code.decode(noisy_llr(code.encode(bits), 5, information), 4);
        CHECK(read.front().bits == bits);
        CHECK(std::ranges::is_sorted(read, {}, &PolarCode::Candidate::cost));
    }
}

TEST_CASE("a list of all words is maximum likelihood") {
    const PolarCode code(32, 6);
    for (std::uint64_t trial = 0; trial < 20; ++trial) {
        const std::vector<double> llr = noisy_llr(code.encode(random_bits(6, trial)), 0.5, trial);
        std::vector<std::uint8_t> best;
        double least = 1e300;
        for (unsigned value = 0; value < 64; ++value) {
            std::vector<std::uint8_t> bits;
            for (int k = 5; k >= 0; --k)
                bits.push_back(value >> k & 1);
            const double c = cost(code.encode(bits), llr);
            if (c < least) {
                least = c;
                best = bits;
            }
        }
        const auto read = code.decode(llr, 64);
        CHECK(read.size() == 64);
        CHECK(read.front().bits == best);
        // Costs are relative probabilities: differences are those of the words themselves.
        CHECK(read[1].cost - read[0].cost ==
              doctest::Approx(cost(code.encode(read[1].bits), llr) - cost(code.encode(read[0].bits), llr)));
    }
}

TEST_CASE("lengths that are no power of two and too much information are refused") {
    CHECK_THROWS_AS(PolarCode(12, 4), ParameterError);
    CHECK_THROWS_AS(PolarCode(16, 17), ParameterError);
}
