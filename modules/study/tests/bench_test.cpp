// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/study/bench.hpp>

#include <cmath>
#include <filesystem>
#include <fstream>

#include <doctest/doctest.h>
#include <fmt/format.h>
#include <unistd.h>

#include <wm3d/core/error.hpp>
#include <wm3d/core/parallel.hpp>
#include <wm3d/shapes.hpp>
#include <wm3d/study/bench_cells.hpp>
#include <wm3d/study/bench_log.hpp>

#include "bench_example.hpp"

using namespace wm3d;
using namespace wm3d::study;

namespace {

using Unit = MarkSize::Unit;

/// A file that goes away.
struct TemporaryFile {
    std::string path =
        fmt::format("{}/wm3d-bench-{}", std::filesystem::temp_directory_path().string(), ::getpid());
    TemporaryFile() { std::filesystem::remove(path); }
    ~TemporaryFile() { std::filesystem::remove(path); }
};

} // namespace

TEST_CASE("a cell holds the worst of its keys, attacks stand in the benchmark's order") {
    const BenchTable table = bench_table(example(), {Unit::mrms, 0.02}, -6);
    CHECK(table.models == std::vector<std::string>{"a.obj", "b.ply"});
    CHECK(table.attacks == std::vector<std::string>{"file", "noise:0.3", "cropping:50", "bend:5+noise:0.3"});
    const BenchCell& noise = table.cells[1][0];
    CHECK(noise.keys == 2);
    CHECK(noise.missed == 1);
    CHECK(noise.worst_log10_p == -4);
    CHECK(noise.worst_key == 1);
    CHECK(table.cells[2][1].error == "nothing is left");
    CHECK(table.cells[2][1].keys == 0);
    CHECK(table.filled() == 6);
    CHECK(table.missed() == 2);
    CHECK(table.marks[0].largest_mrms == doctest::Approx(0.019));
    CHECK(table.assisted.empty());
    CHECK(bench_table(example(), {Unit::strength, 0.02}, -6).models.empty());
}

TEST_CASE("a p that is no number counts as missed") {
    BenchResults results = example();
    results.items[item_name(mark_name("a.obj", {Unit::mrms, 0.02}, 0), "file")].log10_p = NAN;
    CHECK(bench_table(results, {Unit::mrms, 0.02}, -6).cells[0][0].missed == 1);
}

TEST_CASE("wrong keys are judged by the binomial distribution") {
    BenchResults results;
    BenchItem& item = results.items[item_name(mark_name("a.obj", {}, 0), "file")];
    for (int k = 1; k <= 1000; ++k) {
        item.wrong.push_back(std::log10(std::min(1.0, k / 500.0)));
        item.wrong_one.push_back(std::log10((k - 0.5) / 1000.0));
    }
    const WrongKeys fair = count_wrong_keys(results);
    CHECK(fair.keys == 1000);
    CHECK(fair.counts[0].family == 50);
    CHECK(fair.counts[0].family_excess > 0.999);
    CHECK(fair.counts[0].one == 100);
    CHECK(fair.counts[0].one_strays > 0.9);
    CHECK(fair.uniformity > 0.999);
    for (double& x : item.wrong_one)
        x -= 0.2; // each p too small
    for (double& x : item.wrong)
        x -= 0.6;
    const WrongKeys foul = count_wrong_keys(results);
    CHECK(foul.counts[0].family_excess < 1e-9);
    CHECK(foul.counts[0].one_strays < 1e-6);
    CHECK(foul.uniformity < 1e-6);
}

TEST_CASE("results come back from the file, without a line that was cut off") {
    const TemporaryFile file;
    const nlohmann::ordered_json settings{{"seed", 1}};
    const ItemName name = item_name(mark_name("a.obj", {Unit::mrms, 0.02}, 3), "noise:0.3");
    BenchItem item = found(-12.5);
    item.wrong = {-0.25, -1};
    item.assisted = AssistedResult{-40, true, 0.5};
    item.searched = SearchedResult{true, 96};
    item.payload = PayloadResult{64, 3, true, false, -70.5};
    {
        BenchLog log(file.path, settings);
        log.add_command("wm3d bench");
        log.add_command("wm3d bench");
        log.add("a.obj", {"0123", 10, 20, ""});
        log.add("a.obj", {"0123", 10, 20, ""});
        log.add(name.mark, {0.02, 0.03, 0.02, 0.019, NAN, 0.11, ""});
        log.add(name, item);
    }
    const auto whole = std::filesystem::file_size(file.path);
    std::ofstream(file.path, std::ios::app) << "{\"kind\":\"item\",\"mod";
    {
        BenchLog log(file.path, settings);
        const BenchResults& back = log.results();
        CHECK(back.commands == std::vector<std::string>{"wm3d bench"});
        CHECK(back.models.at("a.obj").triangles == 20);
        CHECK(back.marks.at(name.mark).mrms == 0.019);
        CHECK(std::isnan(back.marks.at(name.mark).msdm2));
        CHECK(back.marks.at(name.mark).msdm2_both == 0.11);
        CHECK(back.items.at(name).log10_p == -12.5);
        CHECK(back.items.at(name).wrong == item.wrong);
        CHECK(back.items.at(name).assisted->coverage == 0.5);
        CHECK(back.items.at(name).searched->centres == 96);
        REQUIRE(back.items.at(name).payload);
        CHECK(back.items.at(name).payload->raw_errors == 3);
        CHECK(back.items.at(name).payload->read);
        CHECK(back.items.at(name).payload->log10_p == -70.5);
        CHECK_THROWS_WITH_AS(log.add("a.obj", {"4567", 10, 20, ""}), doctest::Contains("another mesh"),
                             InputError);
    }
    CHECK(std::filesystem::file_size(file.path) == whole);
    CHECK_THROWS_WITH_AS(BenchLog(file.path, {{"seed", 2}}), doctest::Contains("seed is 1 there and 2 here"),
                         InputError);
    for (const char* line :
         {"no JSON", R"({"kind":"mark","model":"a.obj","strength_asked":0.1,"key":1e300})"}) {
        std::ofstream(file.path, std::ios::app) << line << '\n';
        CHECK_THROWS_WITH_AS(BenchLog(file.path, settings), doctest::Contains("line 6"), InputError);
        std::filesystem::resize_file(file.path, whole);
    }
}

TEST_CASE("results are the same at any number of threads, and only what lacks is done") {
    const TriangleMesh mesh = shapes::blob(3000, 5);
    BenchSetting setting;
    setting.sizes = {{Unit::mrms, 0.2}};
    setting.attacks = {attack::parse_chain("noise:0.1"), attack::parse_chain("cropping:10+flips:20")};
    setting.keys = 2;
    setting.wrong_keys = 3;
    setting.search_effort = 0.004;
    setting.payload = 32;
    const auto bench = [&](std::size_t threads, std::size_t expected) {
        const TemporaryFile file;
        const ThreadLimit limit(threads);
        BenchLog log(file.path, {});
        const BenchWork work = missing_work("blob", setting, log.results());
        std::size_t done = 0;
        run_bench(mesh, setting, work, log, [&] { ++done; });
        CHECK(done == expected);
        CHECK(missing_work("blob", setting, log.results()).items.empty());
        setting.keys = 3;
        CHECK(missing_work("blob", setting, log.results()).items.size() == 2);
        setting.keys = 2;
        setting.assisted = true; // the same copies, with the original
        CHECK(missing_work("blob", setting, log.results()).items.size() == 4);
        setting.assisted = false;
        return log.results();
    };
    const BenchResults one = bench(1, 4), many = bench(0, 4);
    REQUIRE(one.items.size() == 4);
    for (const auto& [name, item] : one.items) {
        const std::string& attack = name.attack; // clang before 16 can't capture a part of a binding
        CAPTURE(attack);
        CHECK(item.error.empty());
        CHECK(item.log10_p == many.items.at(name).log10_p);
        CHECK(item.wrong == many.items.at(name).wrong);
        CHECK(item.wrong.size() == 3);
        CHECK(item.searched.has_value() == attack.starts_with("cropping"));
        REQUIRE(item.payload);
        CHECK(item.payload->bits == 32);
        CHECK(item.payload->raw_errors == many.items.at(name).payload->raw_errors);
        CHECK(item.payload->log10_p == many.items.at(name).payload->log10_p);
        if (attack == "noise:0.1") {
            CHECK(item.payload->read);
            CHECK(item.payload->raw_errors <= 1);
        }
    }
    for (const auto& [name, mark] : one.marks) {
        CHECK(mark.mrms <= 0.2);
        CHECK(mark.mrms >= 0.99 * 0.2);
        CHECK(mark.strength == many.marks.at(name).strength);
    }
}
