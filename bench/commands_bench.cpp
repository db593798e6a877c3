// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The whole of `mark` (self-check included) and of `verify`, file to file, as ratios against the time that
/// meshopt_simplify alone takes to bring the same model to 10,000 vertices, measured in turn in one run.
#include <chrono>
#include <cstdlib>
#include <filesystem>
#include <vector>

#include <benchmark/benchmark.h>
#include <meshoptimizer.h>

#include <wm3d/io.hpp>
#include <wm3d/key.hpp>

#include "pipeline/mark.hpp"
#include "pipeline/verify.hpp"

namespace {

using namespace wm3d;

std::filesystem::path bunny() {
    const char* folder = std::getenv("WM3D_MESHES");
    return std::filesystem::path(folder == nullptr ? "../shared/meshes" : folder) / "stanford-bunny.obj";
}

template <typename Work>
double seconds(Work&& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
}

/// The peer's input: floats and one index list, prepared outside the timing.
struct Peer {
    std::vector<float> positions;
    std::vector<unsigned> indices;
    std::size_t target_indices = 0;

    explicit Peer(const TriangleMesh& mesh) {
        for (const Vec3& p : mesh.positions)
            for (int k = 0; k < 3; ++k)
                positions.push_back(static_cast<float>(p[k]));
        for (const Triangle& t : mesh.triangles)
            indices.insert(indices.end(), t.begin(), t.end());
        const double kept = 10000.0 / static_cast<double>(mesh.positions.size());
        target_indices = 3 * static_cast<std::size_t>(static_cast<double>(mesh.triangles.size()) * kept);
    }

    double simplify() const {
        std::vector<unsigned> result(indices.size());
        return seconds([&] {
            benchmark::DoNotOptimize(meshopt_simplify(result.data(), indices.data(), indices.size(), positions.data(),
                                                      positions.size() / 3, 3 * sizeof(float), target_indices, 1.0f, 0,
                                                      nullptr));
        });
    }
};

void mark_file(const std::filesystem::path& in, const std::filesystem::path& out, const key::Key& key) {
    const io::Model model = io::read(in);
    const pipeline::Marked marked = pipeline::mark(model.mesh(), key, {});
    const io::PatchedFiles files = model.patched_files(marked.positions, out.filename().string());
    const io::Model written = io::parse(files.bytes, model.format(), out.string());
    benchmark::DoNotOptimize(pipeline::verify(written.mesh(), key, {}));
    io::write_files(out, files, {.overwrite = true});
}

template <typename Work>
void compare(benchmark::State& state, Work&& work) {
    const Peer peer(io::read(bunny()).mesh());
    double own = 0, other = 0;
    for (auto _ : state) {
        other += peer.simplify();
        const double t = seconds(work);
        own += t;
        state.SetIterationTime(t);
    }
    state.counters["ratio"] = own / other;
    state.counters["meshopt_ms"] = 1e3 * other / static_cast<double>(state.iterations());
}

void whole_mark(benchmark::State& state) {
    const key::Key key = key::Key::generate("bench");
    const auto out = std::filesystem::temp_directory_path() / "wm3d_bench_marked.obj";
    compare(state, [&] { mark_file(bunny(), out, key); });
    std::filesystem::remove(out);
}

void whole_verify(benchmark::State& state) {
    const key::Key key = key::Key::generate("bench");
    const auto out = std::filesystem::temp_directory_path() / "wm3d_bench_suspect.obj";
    mark_file(bunny(), out, key);
    compare(state, [&] { benchmark::DoNotOptimize(pipeline::verify(io::read(out).mesh(), key, {})); });
    std::filesystem::remove(out);
}

BENCHMARK(whole_mark)->UseManualTime()->Iterations(10)->Unit(benchmark::kMillisecond);
BENCHMARK(whole_verify)->UseManualTime()->Iterations(10)->Unit(benchmark::kMillisecond);

} // namespace

BENCHMARK_MAIN();
