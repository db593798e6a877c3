// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Repeatable variety that needs no secrecy. Keys have streams of their own (module key).
#pragma once

#include <cstdint>

namespace wm3d {

/// The next number of the sequence SplitMix64 (Steele, Lea, Flood 2014) that `state` stands in.
inline std::uint64_t split_mix(std::uint64_t& state) {
    std::uint64_t z = (state += 0x9e3779b97f4a7c15u);
    z = (z ^ (z >> 30)) * 0xbf58476d1ce4e5b9u;
    z = (z ^ (z >> 27)) * 0x94d049bb133111ebu;
    return z ^ (z >> 31);
}

} // namespace wm3d
