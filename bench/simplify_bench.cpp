// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Simplification with and without the MAPS parameterization, to 10,000 vertices, as ratios against
/// meshopt_simplify doing the same reduction in turn in one run: on the bunny, and on the bunny
/// Loop-subdivided twice (1.1 million faces).
#include <benchmark/benchmark.h>

#include <wm3d/attack.hpp>
#include <wm3d/io.hpp>
#include <wm3d/maps.hpp>

#include "peer.hpp"

namespace {

using namespace wm3d;

TriangleMesh model(bool subdivided) {
    const TriangleMesh mesh = io::read(bench::bunny()).mesh();
    return subdivided ? attack::apply(mesh, attack::parse_chain("subdivision:loop+subdivision:loop"), 1)
                      : mesh;
}

template<typename Work>
void compare(benchmark::State& state, bool subdivided, Work&& work) {
    const TriangleMesh mesh = model(subdivided);
    const bench::Peer peer(mesh);
    simplify::Options options;
    options.target_vertices = 10000;
    bench::ratio(state, peer, [&] { work(mesh, options); });
    state.counters["faces"] = static_cast<double>(mesh.triangles.size());
}

void simplify_alone(benchmark::State& state, bool subdivided) {
    compare(state, subdivided, [](const TriangleMesh& mesh, const simplify::Options& options) {
        benchmark::DoNotOptimize(simplify::simplify(mesh, options));
    });
}

void simplify_and_maps(benchmark::State& state, bool subdivided) {
    compare(state, subdivided, [](const TriangleMesh& mesh, const simplify::Options& options) {
        benchmark::DoNotOptimize(maps::parameterize(mesh, options));
    });
}

BENCHMARK_CAPTURE(simplify_alone, bunny, false)
    ->UseManualTime()
    ->Iterations(10)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(simplify_and_maps, bunny, false)
    ->UseManualTime()
    ->Iterations(10)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(simplify_alone, million, true)
    ->UseManualTime()
    ->Iterations(3)
    ->Unit(benchmark::kMillisecond);
BENCHMARK_CAPTURE(simplify_and_maps, million, true)
    ->UseManualTime()
    ->Iterations(3)
    ->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();
