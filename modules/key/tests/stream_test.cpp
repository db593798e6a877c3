// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/key/stream.hpp>

#include <cmath>
#include <numeric>

#include <doctest/doctest.h>
#include <wm3d/core/error.hpp>
#include <wm3d/core/parallel.hpp>

#include "fixed_secret.hpp"
#include "stream_vectors.hpp"

using namespace wm3d;
using namespace wm3d::key;

namespace {

std::vector<std::uint64_t> words(Purpose purpose, std::uint64_t index, std::size_t count) {
    std::vector<std::uint64_t> result(count);
    Stream(fixed_secret(), purpose, index).fill(result);
    return result;
}

double correlation(const std::vector<double>& a, const std::vector<double>& b) {
    return std::inner_product(a.begin(), a.end(), b.begin(), 0.0) /
           std::sqrt(std::inner_product(a.begin(), a.end(), a.begin(), 0.0) *
                     std::inner_product(b.begin(), b.end(), b.begin(), 0.0));
}

} // namespace

TEST_CASE("streams are those of the independent generator, for every purpose and index") {
    for (const WordVector& vector : word_vectors)
        CHECK(words(vector.purpose, vector.index, vector.position + 1).back() == vector.word);
}

TEST_CASE("a label's index is that of the independent generator") {
    for (const LabelVector& vector : label_vectors)
        CHECK(index_of(vector.label) == vector.index);
}

TEST_CASE("watermark sequences are those of the independent generator, at every level") {
    for (unsigned level = 0; level <= max_level; ++level) {
        const std::vector<double> w = watermark_sequence(fixed_secret(), level, 0.1);
        CHECK(w.size() == sequence_length(level));
        for (const HeightVector& vector : height_vectors)
            if (vector.level == level)
                CHECK(w[vector.vertex] == vector.height);
    }
}

TEST_CASE("a stream goes on where the last fill ended") {
    const std::vector<std::uint64_t> whole = words(Purpose::trial, 3, 3000);
    Stream stream(fixed_secret(), Purpose::trial, 3);
    std::vector<std::uint64_t> joined;
    for (std::size_t part : {1u, 6u, 1u, 0u, 9u, 500u, 1001u, 1482u}) {
        std::vector<std::uint64_t> next(part);
        stream.fill(next);
        joined.insert(joined.end(), next.begin(), next.end());
    }
    CHECK(joined == whole);
}

TEST_CASE("numbers are the words' numbers, at one thread and at many") {
    const std::vector<std::uint64_t> from = words(Purpose::trial, 9, 200000);
    const auto numbers = [] {
        std::vector<double> result(200000);
        Stream stream(fixed_secret(), Purpose::trial, 9);
        stream.fill_symmetric(std::span(result).first(77), 0.25);
        stream.fill_symmetric(std::span(result).subspan(77), 0.25);
        return result;
    };
    const std::vector<double> many = numbers();
    const ThreadLimit one(1);
    CHECK(numbers() == many);
    bool same = true;
    for (std::size_t i = 0; i < from.size(); ++i)
        same = same && many[i] == 0.25 * symmetric_unit(from[i]);
    CHECK(same);
}

TEST_CASE("the mapping to (-1, 1) is antisymmetric, odd in its last bit, and never reaches the ends") {
    CHECK(symmetric_unit(0) == -1 + 0x1p-53);
    CHECK(symmetric_unit(~std::uint64_t{0}) == 1 - 0x1p-53);
    CHECK(symmetric_unit(std::uint64_t{1} << 63) == 0x1p-53);
    for (std::uint64_t word : words(Purpose::trial, 1, 1000))
        CHECK(symmetric_unit(~word) == -symmetric_unit(word));
}

TEST_CASE("a watermark sequence has the moments of the uniform law and lies within Rmax") {
    const double rmax = 0.3;
    const std::vector<double> w = watermark_sequence(null_secret(5, 1), 7, rmax);
    const auto n = static_cast<double>(w.size());
    double mean = 0, square = 0, largest = 0;
    for (double x : w) {
        mean += x / n;
        square += x * x / n;
        largest = std::max(largest, std::abs(x));
    }
    CHECK(largest < rmax);
    CHECK(largest > 0.999 * rmax);
    // Five standard errors: sd(w) = rmax / sqrt 3, sd(w^2) = rmax^2 sqrt(4 / 45).
    CHECK(std::abs(mean) < 5 * rmax / std::sqrt(3 * n));
    CHECK(std::abs(square - rmax * rmax / 3) < 5 * rmax * rmax * std::sqrt(4 / (45 * n)));
}

TEST_CASE("purposes, levels and keys give uncorrelated sequences") {
    const std::size_t n = sequence_length(5);
    std::vector<std::vector<double>> sequences;
    for (const Secret& secret : {null_secret(1, 1), null_secret(1, 2)})
        for (Purpose purpose : {Purpose::watermark, Purpose::payload, Purpose::trial})
            for (std::uint64_t index : {5u, 6u}) {
                sequences.emplace_back(n);
                Stream(secret, purpose, index).fill_symmetric(sequences.back());
            }
    for (std::size_t a = 0; a < sequences.size(); ++a)
        for (std::size_t b = 0; b < a; ++b)
            CHECK(std::abs(correlation(sequences[a], sequences[b])) < 5 / std::sqrt(static_cast<double>(n)));
}

TEST_CASE("levels and heights out of range are refused") {
    CHECK_THROWS_AS(watermark_sequence(fixed_secret(), max_level + 1, 0.1), ParameterError);
    for (double rmax : {0.0, -0.1, 1.0, std::nan("")})
        CHECK_THROWS_AS(watermark_sequence(fixed_secret(), 3, rmax), ParameterError);
}
