// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The whole of `mark` (self-check included) and of `verify`, file to file, as ratios against the time
/// that meshopt_simplify alone takes to bring the same model to 10,000 vertices, measured in turn in one run:
/// on the bunny, and on the bunny Loop-subdivided twice (1.1 million faces, binary PLY).
#include <filesystem>

#include <benchmark/benchmark.h>

#include <wm3d/attack.hpp>
#include <wm3d/io.hpp>
#include <wm3d/key.hpp>
#include <wm3d/watermark/mark_file.hpp>

#include "peer.hpp"

namespace {

using namespace wm3d;
namespace fs = std::filesystem;

/// A folder that goes away, with a model and its marked copy.
struct Workshop {
    fs::path folder = fs::temp_directory_path() / "wm3d_commands_bench";
    fs::path in, out;
    key::Key key = key::Key::generate("bench");

    explicit Workshop(bool dense) {
        fs::create_directory(folder);
        in = dense ? folder / "dense.ply" : bench::bunny();
        out = folder / (dense ? "marked.ply" : "marked.obj");
        if (dense) {
            const TriangleMesh mesh = attack::apply(
                io::read(bench::bunny()).mesh(), attack::parse_chain("subdivision:loop+subdivision:loop"), 1);
            io::write_file(in, io::encode(mesh, io::Format::ply), {.overwrite = true});
        }
    }
    ~Workshop() { fs::remove_all(folder); }

    void mark() const {
        watermark::MarkFileOptions options;
        options.overwrite = true;
        benchmark::DoNotOptimize(watermark::mark_file(in, out, key, options));
    }
    void verify() const { benchmark::DoNotOptimize(watermark::verify(io::read(out).mesh(), key)); }
};

void whole_mark(benchmark::State& state, bool dense) {
    const Workshop shop(dense);
    bench::ratio(state, bench::Peer(io::read(shop.in).mesh()), [&] { shop.mark(); });
}

void whole_verify(benchmark::State& state, bool dense) {
    const Workshop shop(dense);
    shop.mark();
    bench::ratio(state, bench::Peer(io::read(shop.in).mesh()), [&] { shop.verify(); });
}

#define WM3D_BENCH(function, name, dense, iterations)                                                        \
    BENCHMARK_CAPTURE(function, name, dense)                                                                 \
        ->UseManualTime()                                                                                    \
        ->Iterations(iterations)                                                                             \
        ->Unit(benchmark::kMillisecond)

WM3D_BENCH(whole_mark, bunny, false, 10);
WM3D_BENCH(whole_verify, bunny, false, 10);
WM3D_BENCH(whole_mark, dense, true, 3);
WM3D_BENCH(whole_verify, dense, true, 3);

} // namespace

BENCHMARK_MAIN();
