// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Pseudo-random numbers from a secret, one independent stream per purpose.
/// This work is based on Bernstein's ChaCha20 and on BLAKE2b (RFC 7693) as keyed hash.
#pragma once

#include <array>
#include <cstddef>
#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <wm3d/key/secret.hpp>

namespace wm3d::key {

/// What a stream is for. Streams of different purposes share no key, so what leaks of one tells nothing of
/// another.
enum class Purpose {
    watermark, ///< W of section 2.2.1; the stream's index is the subdivision level
    payload,   ///< spreading of a readable payload
    recipient, ///< signs that tell copies apart; the stream's index is `index_of` what the copy is
    trial,     ///< choices of experiments; never part of a mark
};

/// 2^-53 (2k + 1) - 1 with k the upper 53 bits of `word`: the midpoints of 2^53 equal parts of (-1, 1).
/// Exact, never -1, 0 or 1, and exactly antisymmetric: the complement of a word gives the negative number.
constexpr double symmetric_unit(std::uint64_t word) {
    constexpr std::int64_t half = std::int64_t{1} << 53;
    return static_cast<double>(static_cast<std::int64_t>((word >> 11) * 2 + 1) - half) * 0x1p-53;
}

/// An endless sequence of 64-bit words: the ChaCha20 (64-bit nonce and counter) key stream read as
/// little-endian words, with keyed BLAKE2b of the purpose as its key and the index as its nonce.
class Stream {
public:
    Stream(const Secret& secret, Purpose purpose, std::uint64_t index);
    ~Stream();
    Stream(const Stream&) = default;
    Stream& operator=(const Stream&) = default;

    /// The next words.
    void fill(std::span<std::uint64_t> words);

    /// The next words as numbers scale * symmetric_unit(word). In parallel, and the same at any number of
    /// threads.
    void fill_symmetric(std::span<double> numbers, double scale = 1);

private:
    std::array<std::uint8_t, 32> subkey_;
    std::array<std::uint8_t, 8> nonce_;
    std::uint64_t position_ = 0; ///< words that were handed out
};

/// 64 bits of the BLAKE2b hash of a public label, for streams that belong to something with a name.
std::uint64_t index_of(std::string_view label);

/// Finest subdivision level a watermark sequence is made for.
inline constexpr unsigned max_level = 9;

/// Number of vertices of the sphere of a level: 10 * 4^level + 2.
constexpr std::size_t sequence_length(unsigned level) {
    return 10 * (std::size_t{1} << (2 * level)) + 2;
}

/// W of section 2.2.1: #sequence_length(level) heights, independent and uniform in (-rmax, rmax), in the
/// order of the sphere's vertices. Sequences of different levels are independent; rmax only scales.
/// \throw ParameterError if level > max_level or rmax is not in (0, 1)
std::vector<double> watermark_sequence(const Secret& secret, unsigned level, double rmax);

} // namespace wm3d::key
