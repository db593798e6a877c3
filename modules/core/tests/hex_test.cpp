// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/core/hex.hpp>

#include <array>
#include <cstdio>

#include <doctest/doctest.h>

TEST_CASE("every byte has its two digits") {
    for (unsigned value = 0; value < 256; ++value) {
        std::array<char, 3> expected{};
        std::snprintf(expected.data(), expected.size(), "%02x", value);
        const std::array<std::uint8_t, 1> byte{static_cast<std::uint8_t>(value)};
        CHECK(wm3d::to_hex(byte) == expected.data());
    }
    CHECK(wm3d::to_hex({}).empty());
}
