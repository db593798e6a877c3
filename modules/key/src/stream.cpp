// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/key/stream.hpp>

#include <algorithm>
#include <string_view>

#include <fmt/format.h>
#include <sodium.h>

#include <wm3d/core/error.hpp>
#include <wm3d/core/parallel.hpp>

#include "sodium.hpp"

namespace wm3d::key {

namespace {

constexpr std::size_t words_per_cipher_block = 8;

std::string_view purpose_text(Purpose purpose) {
    switch (purpose) {
    case Purpose::watermark:
        return "wm3d/1 stream watermark";
    case Purpose::payload:
        return "wm3d/1 stream payload";
    case Purpose::recipient:
        return "wm3d/1 stream recipient";
    case Purpose::trial:
        return "wm3d/1 stream trial";
    }
    throw ParameterError("a stream was asked for a purpose that doesn't exist");
}

std::uint64_t read_word(const std::uint8_t* bytes) {
    std::uint64_t word = 0;
    for (int i = 7; i >= 0; --i)
        word = word << 8 | bytes[i];
    return word;
}

/// Key stream by position: words first, first + 1, ... go to take(0, word), take(1, word), ...
template<typename Take>
void generate(const std::array<std::uint8_t, 32>& subkey, const std::array<std::uint8_t, 8>& nonce,
              std::uint64_t first, std::size_t count, Take&& take) {
    constexpr std::size_t chunk = 512; // words: 4 KiB stay in the nearest cache
    std::array<std::uint8_t, 8 * chunk> bytes;
    std::uint64_t block = first / words_per_cipher_block;
    std::size_t skipped = first % words_per_cipher_block;
    for (std::size_t done = 0; done < count;) {
        const std::size_t words = std::min(chunk - skipped, count - done);
        const std::size_t length = 8 * (skipped + words);
        std::fill_n(bytes.begin(), length, std::uint8_t{0});
        crypto_stream_chacha20_xor_ic(bytes.data(), bytes.data(), length, nonce.data(), block, subkey.data());
        for (std::size_t i = 0; i < words; ++i)
            take(done + i, read_word(&bytes[8 * (skipped + i)]));
        done += words;
        block += chunk / words_per_cipher_block;
        skipped = 0;
    }
}

} // namespace

Stream::Stream(const Secret& secret, Purpose purpose, std::uint64_t index) : nonce_(little_endian(index)) {
    blake2b(subkey_, bytes_of(purpose_text(purpose)), secret.bytes());
}

Stream::~Stream() {
    sodium_memzero(subkey_.data(), subkey_.size());
}

void Stream::fill(std::span<std::uint64_t> words) {
    generate(subkey_, nonce_, position_, words.size(),
             [&](std::size_t i, std::uint64_t word) { words[i] = word; });
    position_ += words.size();
}

void Stream::fill_symmetric(std::span<double> numbers, double scale) {
    parallel_blocks(numbers.size(), 65536, [&](std::size_t begin, std::size_t end) {
        double* out = numbers.data() + begin;
        generate(subkey_, nonce_, position_ + begin, end - begin,
                 [&](std::size_t i, std::uint64_t word) { out[i] = scale * symmetric_unit(word); });
    });
    position_ += numbers.size();
}

std::uint64_t index_of(std::string_view label) {
    std::array<std::uint8_t, 16> digest; // BLAKE2b offers no shorter one
    blake2b(digest, bytes_of(label), bytes_of("wm3d/1 label"));
    return read_word(digest.data());
}

std::vector<double> watermark_sequence(const Secret& secret, unsigned level, double rmax) {
    if (level > max_level)
        throw ParameterError(fmt::format(
            "level {} is too fine for a watermarking sphere; choose one from 0 to {}", level, max_level));
    if (!(rmax > 0 && rmax < 1))
        throw ParameterError(
            fmt::format("rmax is {}; bumps on a sphere of radius 1 need one between 0 and 1", rmax));
    std::vector<double> heights(sequence_length(level));
    Stream(secret, Purpose::watermark, level).fill_symmetric(heights, rmax);
    return heights;
}

} // namespace wm3d::key
