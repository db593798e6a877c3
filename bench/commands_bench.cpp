// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The whole of `mark` (self-check included) and of `verify`, file to file, as ratios against the time
/// that meshopt_simplify alone takes to bring the same model to 10,000 vertices, measured in turn in one run.
#include <filesystem>

#include <benchmark/benchmark.h>

#include <wm3d/io.hpp>
#include <wm3d/key.hpp>
#include <wm3d/watermark/mark.hpp>
#include <wm3d/watermark/verify.hpp>

#include "peer.hpp"

namespace {

using namespace wm3d;

using bench::bunny;

void mark_file(const std::filesystem::path& in, const std::filesystem::path& out, const key::Key& key) {
    const io::Model model = io::read(in);
    const watermark::Marked marked = watermark::mark(model.mesh(), key, {});
    const io::PatchedFiles files = model.patched_files(marked.positions, out.filename().string());
    const io::Model written = io::parse(files.bytes, model.format(), out.string());
    benchmark::DoNotOptimize(watermark::verify(written.mesh(), key, {}));
    io::write_files(out, files, {.overwrite = true});
}

bench::Peer peer() {
    return bench::Peer(io::read(bunny()).mesh());
}

void whole_mark(benchmark::State& state) {
    const key::Key key = key::Key::generate("bench");
    const auto out = std::filesystem::temp_directory_path() / "wm3d_bench_marked.obj";
    bench::ratio(state, peer(), [&] { mark_file(bunny(), out, key); });
    std::filesystem::remove(out);
}

void whole_verify(benchmark::State& state) {
    const key::Key key = key::Key::generate("bench");
    const auto out = std::filesystem::temp_directory_path() / "wm3d_bench_suspect.obj";
    mark_file(bunny(), out, key);
    bench::ratio(state, peer(),
                 [&] { benchmark::DoNotOptimize(watermark::verify(io::read(out).mesh(), key, {})); });
    std::filesystem::remove(out);
}

BENCHMARK(whole_mark)->UseManualTime()->Iterations(10)->Unit(benchmark::kMillisecond);
BENCHMARK(whole_verify)->UseManualTime()->Iterations(10)->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();
