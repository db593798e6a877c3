// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/report/table.hpp>

#include <doctest/doctest.h>

using wm3d::report::Table;

namespace {

Table example_table() {
    return {{"name", "P_m"}, {{"n = 5", "1e-3"}, {"γ", "12"}}};
}

} // namespace

TEST_CASE("text columns are aligned by what is seen, numbers to the right") {
    CHECK(to_text(example_table()) == "name    P_m\n"
                                      "n = 5  1e-3\n"
                                      "γ        12\n");
}

TEST_CASE("CSV quotes what would break a line or a column") {
    const Table table{{"a", "b"}, {{"1,5", "say \"no\""}, {"two\nlines", "plain"}}};
    CHECK(to_csv(table) == "a,b\n\"1,5\",\"say \"\"no\"\"\"\n\"two\nlines\",plain\n");
}

TEST_CASE("Markdown escapes the bar and says which columns are numbers") {
    const Table table{{"a", "b"}, {{"x|y", "1"}}};
    CHECK(to_markdown(table) == "| a | b |\n| --- | ---: |\n| x\\|y | 1 |\n");
}
