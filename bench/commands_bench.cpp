// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The whole of `mark` (self-check included) and of `verify`, file to file, as ratios against the time
/// that meshopt_simplify alone takes to bring the same model to 10,000 vertices, measured in turn in one run:
/// on the bunny, and on the bunny Loop-subdivided twice (1.1 million faces, binary PLY). And the slope of the time of
/// `mark` over the faces, from there to 17.8 million.
#include <cmath>
#include <filesystem>
#include <string>

#include <benchmark/benchmark.h>
#include <fmt/format.h>

#include <wm3d/attack.hpp>
#include <wm3d/io.hpp>
#include <wm3d/key.hpp>
#include <wm3d/watermark/mark_file.hpp>

#include "memory.hpp"
#include "peer.hpp"

namespace {

using namespace wm3d;
namespace fs = std::filesystem;

/// A folder that goes away, with the bunny Loop-subdivided some times and its marked copy.
struct Workshop {
    fs::path folder;
    fs::path in, out;
    key::Key key = key::Key::generate("bench");

    explicit Workshop(int subdivisions)
        : folder(fs::temp_directory_path() / fmt::format("wm3d_commands_bench_{}", subdivisions)) {
        fs::create_directory(folder);
        in = subdivisions > 0 ? folder / "dense.ply" : bench::bunny();
        out = folder / (subdivisions > 0 ? "marked.ply" : "marked.obj");
        if (subdivisions > 0) {
            TriangleMesh mesh = io::read(bench::bunny()).mesh();
            for (int n = 0; n < subdivisions; ++n)
                mesh = attack::apply(mesh, attack::parse_chain("subdivision:loop"), 1);
            io::write_file(in, io::encode(mesh, io::Format::ply), {.overwrite = true});
        }
    }
    Workshop(const Workshop&) = delete;
    Workshop& operator=(const Workshop&) = delete;
    ~Workshop() { fs::remove_all(folder); }

    std::size_t faces() const { return io::read(in).mesh().triangles.size(); }
    void mark() const {
        watermark::MarkFileOptions options;
        options.overwrite = true;
        benchmark::DoNotOptimize(watermark::mark_file(in, out, key, options));
    }
    void verify() const { benchmark::DoNotOptimize(watermark::verify(io::read(out).mesh(), key)); }
};

void whole_mark(benchmark::State& state, int subdivisions) {
    const Workshop shop(subdivisions);
    bench::ratio(state, bench::Peer(io::read(shop.in).mesh()), [&] { shop.mark(); });
}

void whole_verify(benchmark::State& state, int subdivisions) {
    const Workshop shop(subdivisions);
    shop.mark();
    bench::ratio(state, bench::Peer(io::read(shop.in).mesh()), [&] { shop.verify(); });
}

/// The power of the faces that the time of `mark` grows with between two densities, of which the lower is marked before and
/// after the higher.
void mark_slope(benchmark::State& state, int fewer, int more) {
    constexpr int marks = 3; // each time
    const Workshop dense(fewer), denser(more);
    bench::Times of_dense, of_denser;
    const auto mark_dense = [&] {
        for (int n = 0; n < marks; ++n)
            of_dense += bench::timed([&] { dense.mark(); });
    };
    for (auto _ : state) {
        mark_dense();
        const bench::Times t = bench::timed([&] { denser.mark(); });
        of_denser += t;
        state.SetIterationTime(t.wall);
        mark_dense();
    }
    const double more_faces =
        std::log(static_cast<double>(denser.faces()) / static_cast<double>(dense.faces()));
    state.counters["slope"] = std::log(2 * marks * of_denser.wall / of_dense.wall) / more_faces;
    state.counters["cpu_slope"] = std::log(2 * marks * of_denser.cpu / of_dense.cpu) / more_faces;
    state.counters["fewer_ms"] = 1e3 * of_dense.wall / static_cast<double>(2 * marks * state.iterations());
}

#define WM3D_BENCH(function, name, iterations, ...)                                                          \
    BENCHMARK_CAPTURE(function, name, __VA_ARGS__)                                                           \
        ->UseManualTime()                                                                                    \
        ->Iterations(iterations)                                                                             \
        ->Unit(benchmark::kMillisecond)

WM3D_BENCH(whole_mark, bunny, 10, 0);
WM3D_BENCH(whole_verify, bunny, 10, 0);
WM3D_BENCH(whole_mark, dense, 3, 2);
WM3D_BENCH(whole_verify, dense, 3, 2);
WM3D_BENCH(mark_slope, to_17_million, 1, 2, 4);

} // namespace

int main(int argc, char** argv) {
    cmd::set_up_memory();
    benchmark::Initialize(&argc, argv);
    if (benchmark::ReportUnrecognizedArguments(argc, argv))
        return 2;
    if (!fs::exists(bench::bunny())) {
        fmt::print(stderr,
                   "commands_bench: error: {} is not there; name the folder of the models in WM3D_MESHES\n",
                   bench::bunny().string());
        return 2;
    }
    benchmark::RunSpecifiedBenchmarks();
    return 0;
}
