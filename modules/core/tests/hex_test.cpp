// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/core/hex.hpp>

#include <array>
#include <cstdio>

#include <doctest/doctest.h>

TEST_CASE("every byte has its two digits, and they give it back") {
    for (unsigned value = 0; value < 256; ++value) {
        std::array<char, 3> expected{};
        std::snprintf(expected.data(), expected.size(), "%02x", value);
        const std::array<std::uint8_t, 1> byte{static_cast<std::uint8_t>(value)};
        CHECK(wm3d::to_hex(byte) == expected.data());
        CHECK(wm3d::from_hex(expected.data()) == std::string(1, static_cast<char>(value)));
    }
    CHECK(wm3d::to_hex({}).empty());
    CHECK(wm3d::from_hex("") == "");
}

TEST_CASE("digits of either case are bytes, anything else is not") {
    CHECK(wm3d::from_hex("666F6f") == "foo");
    for (const char* bad : {"f", "0x", "fg", "gf", " f", "f ", "+f", "-1", "666f6", "66 6f", "6\xc3"})
        CHECK_FALSE(wm3d::from_hex(bad).has_value());
    CHECK_FALSE(wm3d::from_hex(std::string_view("f\0", 2)).has_value());
}
