// SPDX-License-Identifier: GPL-3.0-or-later
#include "support/suggest.hpp"

#include <array>

#include <doctest/doctest.h>

using wm3d::cmd::edit_distance;
using wm3d::cmd::nearest_name;

TEST_CASE("edit distance counts insertions, removals, replacements and swaps") {
    CHECK(edit_distance("", "") == 0);
    CHECK(edit_distance("", "mark") == 4);
    CHECK(edit_distance("mark", "mark") == 0);
    CHECK(edit_distance("mark", "marks") == 1);
    CHECK(edit_distance("mark", "ark") == 1);
    CHECK(edit_distance("mark", "bark") == 1);
    CHECK(edit_distance("mark", "makr") == 1);
    CHECK(edit_distance("verify", "keygen") == 5);
}

TEST_CASE("the nearest name is a slip of the finger away") {
    constexpr std::array<std::string_view, 3> names{"mark", "maps", "verify"};
    CHECK(nearest_name("makr", names) == "mark");
    CHECK(nearest_name("verfiy", names) == "verify");
    CHECK(nearest_name("verifie", names) == "verify");
    CHECK(nearest_name("map", names) == "maps");
    CHECK_FALSE(nearest_name("frobnicate", names).has_value());
    CHECK_FALSE(nearest_name("", names).has_value());
}
