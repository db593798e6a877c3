// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Repeatable variety: a counter-based generator, so that the n-th number needs no numbers before it
/// and parallel loops draw the same values at any number of threads. Not for secrets.
#pragma once

#include <cstdint>

#include <wm3d/core/split_mix.hpp>

namespace wm3d::attack {

/// The numbers of one seed and one purpose; number i of the stream is a function of (seed, stream, i) alone.
/// The mixing function is SplitMix64's finalizer.
class RandomStream {
public:
    constexpr RandomStream(std::uint64_t seed, std::uint64_t stream)
        : base_(split_mix_finalizer(split_mix_finalizer(seed) + split_mix_step * (stream + 1))) {}

    /// 64 random bits.
    constexpr std::uint64_t word(std::uint64_t i) const {
        return split_mix_finalizer(base_ + split_mix_step * (i + 1));
    }

    /// A multiple of 2^-53 in [0, 1).
    constexpr double unit(std::uint64_t i) const { return static_cast<double>(word(i) >> 11) * 0x1p-53; }

    constexpr double between(std::uint64_t i, double low, double high) const {
        return low + (high - low) * unit(i);
    }

    /// A whole number in [0, count).
    /// \pre  0 < count < 2^32
    constexpr std::uint64_t below(std::uint64_t i, std::uint64_t count) const {
        return static_cast<std::uint64_t>(unit(i) * static_cast<double>(count));
    }

private:
    std::uint64_t base_;
};

} // namespace wm3d::attack
