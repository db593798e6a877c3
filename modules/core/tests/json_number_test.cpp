// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/core/json_number.hpp>

#include <cstdint>

#include <doctest/doctest.h>
#include <nlohmann/json.hpp>

using namespace wm3d;
using nlohmann::json;

TEST_CASE("whole numbers are read up to the largest of their type") {
    CHECK(whole_number<unsigned>(json::parse("0")) == 0);
    CHECK(whole_number<std::uint8_t>(json::parse("255")) == 255);
    CHECK(whole_number<std::uint64_t>(json::parse("18446744073709551615")) == UINT64_MAX);
}

TEST_CASE("what is no whole number, or none of the type, is the library's error") {
    for (const char* text : {"-1", "3.0", "2.01e302", "\"3\"", "null", "true", "[3]", "18446744073709551616"})
        CHECK_THROWS_AS(whole_number<std::uint64_t>(json::parse(text)), json::exception);
    CHECK_THROWS_AS(whole_number<std::uint8_t>(json::parse("256")), json::exception);
}
