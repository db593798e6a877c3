// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench_summary.hpp"

#include <algorithm>
#include <string>

#include <doctest/doctest.h>

#include "bench_example.hpp"
#include "bench_heat_map.hpp"

using namespace wm3d;
using namespace wm3d::cmd;
using namespace wm3d::study;

TEST_CASE("the summary shows misses as plainly as hits") {
    const BenchSummary summary = summarize(example(), example_setting(), {-6});
    const std::string text = bench_markdown(summary);
    for (const char* part :
         {"**-4.0**", "-50.0", "- noise:0.3: a (1 of 2 keys, worst -4.0), b (1 of 2 keys, worst -4.0)",
          "- cropping:50: b (no copy to examine: nothing is left)", "- c.stl: c.stl: no mesh",
          "4 of 6 cells reach -6", "0.29 (**-3.1**)"})
        CHECK_MESSAGE(text.find(part) != std::string::npos, part);
    const report::HeatMap map = bench_heat_map(summary.tables);
    CHECK(map.rows.size() == 4);
    CHECK(map.groups[0].cells[1][0].alarm);
    CHECK_FALSE(map.groups[0].cells[0][0].alarm);
    CHECK(map.groups[0].cells[2][0].empty);
}

TEST_CASE("the table for programs has a line for every item") {
    const std::string csv = bench_csv(example());
    CHECK(std::ranges::count(csv, '\n') == 1 + 13);
    CHECK(csv.find("b.ply,mrms,0.02,0,cropping:50,0.021,0.018,0.2,,,,,,,,,,nothing is left\n") !=
          std::string::npos);
}
