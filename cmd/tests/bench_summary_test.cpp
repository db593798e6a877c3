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

TEST_CASE("payloads are compared with published bits, in words and numbers") {
    CHECK(bench_markdown(summarize(example(), example_setting(), {-6})).find("Payloads") ==
          std::string::npos);
    BenchResults results = example();
    const auto sent = [&](const char* model, std::size_t key, const char* attack, PayloadResult payload) {
        results.items[item_name(mark_name(model, {MarkSize::Unit::mrms, 0.02}, key), attack)].payload =
            payload;
    };
    // Published at this size: noise 0.10 at best, a file that was only saved anew 0.
    sent("a.obj", 0, "noise:0.3", {64, 4, true, false, -50});
    sent("a.obj", 1, "noise:0.3", {64, 8, false, false, -5});
    sent("b.ply", 0, "noise:0.3", {64, 9, true, false, -40});
    sent("a.obj", 0, "file", {64, 0, true, false, -90});
    sent("a.obj", 1, "file", {64, 0, false, true, -7});
    sent("b.ply", 0, "bend:5+noise:0.3", {64, 30, false, false, 0});

    const BenchSummary summary = summarize(results, example_setting(), {-6});
    const PayloadCount count = count_payloads(summary.tables[0]);
    CHECK(count.bits == 64);
    CHECK(count.keys == 6);
    CHECK(count.read == 3);
    CHECK(count.wrong == 1);
    CHECK(count.published == 3);
    CHECK(count.as_published == 1); // a.obj under noise, of 0.094; b.ply has 0.141
    const std::string text = bench_markdown(summary);
    for (const char* part :
         {"| noise:0.3 | 0.094 / 0.125, 1 of 2 | **0.141 / 0.141, 1 of 1** | 0.10 | 0.29 |",
          "| file | **0.000 / 0.000, 1 of 2** |  | 0.00 | 0.00 |", "| 0.469 / 0.469, 0 of 1 |",
          "3 of 6 payloads were decoded, 1 gave another. 1 of 3 cells"})
        CHECK_MESSAGE(text.find(part) != std::string::npos, part);
    CHECK(bench_csv(results).find(",64,8,0,-5,\n") != std::string::npos);
}

TEST_CASE("the table for programs has a line for every item") {
    const std::string csv = bench_csv(example());
    CHECK(std::ranges::count(csv, '\n') == 1 + 13);
    CHECK(csv.find("b.ply,mrms,0.02,0,cropping:50,0.021,0.018,0.2,,,,,,,,,,,,,,,nothing is left\n") !=
          std::string::npos);
}
