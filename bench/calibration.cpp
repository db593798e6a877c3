// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Prints the tables of docs/calibration.md: calibration KEYS MESH...
#include <cstdlib>
#include <filesystem>

#include <fmt/format.h>

#include <wm3d/core/error.hpp>
#include <wm3d/io.hpp>
#include <wm3d/study/calibration.hpp>

namespace {

using namespace wm3d;

void print_table(const std::filesystem::path& path, std::size_t keys) {
    constexpr unsigned level = 5;
    watermark::ExaminationOptions options;
    options.levels = {level};
    options.resync = watermark::Resync::none;
    const watermark::Examination suspect(io::read(path).mesh(), options);
    const study::Calibration result = study::calibrate(suspect, level, keys, 2026);

    fmt::print("\n### {} ({} base vertices)\n\n| statistic |", path.filename().string(),
               suspect.base_vertices());
    for (double pf : result.pf)
        fmt::print(" {:g} |", pf);
    fmt::print("\n|---|");
    for (std::size_t i = 0; i < result.pf.size(); ++i)
        fmt::print("---|");
    for (const study::TailCounts& counts : result.counts) {
        fmt::print("\n| {}: measured |", counts.statistic);
        for (std::size_t passed : counts.passed)
            fmt::print(" {:.2e} ({}) |", static_cast<double>(passed) / static_cast<double>(keys), passed);
        fmt::print("\n| {}: exact |", counts.statistic);
        for (double expected : counts.expected_pf)
            fmt::print(" {:.2e} |", expected);
    }
    fmt::print("\n");
}

} // namespace

int main(int argc, char** argv) try {
    if (argc < 3) {
        fmt::print(stderr, "usage: calibration KEYS MESH...\n");
        return 2;
    }
    const auto keys = static_cast<std::size_t>(std::strtoull(argv[1], nullptr, 10));
    for (int i = 2; i < argc; ++i)
        print_table(argv[i], keys);
    return 0;
} catch (const wm3d::Error& error) {
    fmt::print(stderr, "calibration: {}\n", error.what());
    return 2;
}
