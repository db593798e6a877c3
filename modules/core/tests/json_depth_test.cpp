// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/core/json_depth.hpp>

#include <string>

#include <doctest/doctest.h>

#include <wm3d/core/error.hpp>

using namespace wm3d;

TEST_CASE("brackets are counted, those in strings are not") {
    CHECK(json_depth("") == 0);
    CHECK(json_depth("7") == 0);
    CHECK(json_depth("[]") == 1);
    CHECK(json_depth(R"({"a": [1, {"b": []}], "c": [[]]})") == 4);
    CHECK(json_depth(R"(["[[[[", "\"[[[[", "\\", []])") == 2);
    CHECK(json_depth("]]]][") == 1);
    CHECK(json_depth("\"[") == 0);
    CHECK(json_depth("\"\\") == 0);
}

TEST_CASE("texts that nest too deep are refused by name") {
    const auto nested = [](std::size_t depth) { return std::string(depth, '[') + std::string(depth, ']'); };
    CHECK_NOTHROW(check_json_depth(nested(max_json_depth), "x.gltf"));
    CHECK_THROWS_WITH_AS(check_json_depth(nested(max_json_depth + 1), "x.gltf"),
                         doctest::Contains("x.gltf: brackets nest 257 deep"), InputError);
}
