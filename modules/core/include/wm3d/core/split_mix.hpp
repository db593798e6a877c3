// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Repeatable variety that needs no secrecy. Keys have streams of their own (module key).
#pragma once

#include <cstdint>

namespace wm3d {

/// Steps of the sequence SplitMix64 (Steele, Lea, Flood 2014), which numbers all 64-bit words.
inline constexpr std::uint64_t split_mix_step = 0x9e3779b97f4a7c15u;

/// What SplitMix64 makes of the word that it stands at.
constexpr std::uint64_t split_mix_finalizer(std::uint64_t z) {
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

/// The next number of the sequence that `state` stands in.
constexpr std::uint64_t split_mix(std::uint64_t& state) {
    return split_mix_finalizer(state += split_mix_step);
}

} // namespace wm3d
