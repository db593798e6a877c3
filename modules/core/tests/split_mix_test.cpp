// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/core/split_mix.hpp>

#include <doctest/doctest.h>

TEST_CASE("the sequence is SplitMix64's") {
    // The first numbers of java.util.SplittableRandom(0), and so of every implementation.
    std::uint64_t state = 0;
    CHECK(wm3d::split_mix(state) == 0xe220a8397b1dcdafu);
    CHECK(wm3d::split_mix(state) == 0x6e789e6aa1b965f4u);
    CHECK(wm3d::split_mix(state) == 0x06c45d188009454fu);
}
