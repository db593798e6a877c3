// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/report/heat_map.hpp>

#include <doctest/doctest.h>

#include "contains.hpp"

using namespace wm3d::report;
using test::contains;

namespace {

HeatMap one_cell(const HeatCell& cell) {
    return {"title", "legend", {"row"}, {{"group", {"column"}, {{cell}}}}};
}

} // namespace

TEST_CASE("shades run from light to dark and the alarm is none of them") {
    const auto script = [](double shade, bool alarm) {
        return gnuplot_script(one_cell({"x", shade, alarm, false}), "svg");
    };
    CHECK(contains(script(0, false), "'#E2EEF7'"));
    CHECK(contains(script(1, false), "'#08386E'"));
    CHECK(contains(script(7, false), "'#08386E'"));
    CHECK(contains(script(0, true), "'#F28E2B'"));
    CHECK(contains(script(1, true), "'#F28E2B'"));
}

TEST_CASE("the text of a dark cell is white") {
    CHECK(
        contains(gnuplot_script(one_cell({"x", 0.9, false, false}), "svg"), "front textcolor rgb '#FFFFFF'"));
    CHECK(
        contains(gnuplot_script(one_cell({"x", 0.1, false, false}), "svg"), "front textcolor rgb '#000000'"));
}

TEST_CASE("an empty cell has no colour") {
    CHECK_FALSE(contains(gnuplot_script(one_cell({}), "svg"), "set object"));
}

TEST_CASE("the picture grows with rows, columns and names") {
    HeatMap map = one_cell({"x", 0, false, false});
    const HeatSize size = heat_map_size(map);
    map.rows.emplace_back("another row with a long name");
    map.groups[0].cells.push_back({{}});
    const HeatSize taller = heat_map_size(map);
    CHECK(taller.height > size.height);
    CHECK(taller.width >= size.width);
    map.groups.push_back(
        {"second", std::vector<std::string>(20, "column"), std::vector(2, std::vector<HeatCell>(20))});
    CHECK(heat_map_size(map).width > taller.width);
}
