// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The peer that timings are ratios against: meshopt_simplify, bringing the same model to 10,000
/// vertices.
#pragma once

#include <chrono>
#include <cstdlib>
#include <ctime>
#include <filesystem>
#include <vector>

#include <benchmark/benchmark.h>
#include <meshoptimizer.h>

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::bench {

inline std::filesystem::path bunny() {
    const char* folder = std::getenv("WM3D_MESHES");
    return std::filesystem::path(folder == nullptr ? "../shared/meshes" : folder) / "stanford-bunny.obj";
}

struct Times {
    double wall = 0, cpu = 0; ///< seconds; cpu is of all threads
    Times& operator+=(const Times& o) {
        wall += o.wall;
        cpu += o.cpu;
        return *this;
    }
};

template<typename Work>
Times timed(Work&& work) {
    const std::clock_t cpu = std::clock();
    const auto wall = std::chrono::steady_clock::now();
    work();
    return {std::chrono::duration<double>(std::chrono::steady_clock::now() - wall).count(),
            static_cast<double>(std::clock() - cpu) / CLOCKS_PER_SEC};
}

/// The peer's input: floats and one index list, prepared outside the timing.
class Peer {
public:
    explicit Peer(const TriangleMesh& mesh) {
        for (const Vec3& p : mesh.positions)
            for (int k = 0; k < 3; ++k)
                positions_.push_back(static_cast<float>(p[k]));
        for (const Triangle& t : mesh.triangles)
            indices_.insert(indices_.end(), t.begin(), t.end());
        const double kept = 10000.0 / static_cast<double>(mesh.positions.size());
        target_indices_ = 3 * static_cast<std::size_t>(static_cast<double>(mesh.triangles.size()) * kept);
    }

    /// What one simplification takes.
    Times simplify() const {
        std::vector<unsigned> result(indices_.size());
        return timed([&] {
            ::benchmark::DoNotOptimize(meshopt_simplify(
                result.data(), indices_.data(), indices_.size(), positions_.data(), positions_.size() / 3,
                3 * sizeof(float), target_indices_, 1.0f, 0, nullptr));
        });
    }

private:
    std::vector<float> positions_;
    std::vector<unsigned> indices_;
    std::size_t target_indices_ = 0;
};

/// Runs the peer and `work` in turn; reports the time of `work` and, as counters, the ratios of the sums: of
/// the clock and, which holds on a machine that others use too, of processor time.
template<typename Work>
void ratio(::benchmark::State& state, const Peer& peer, Work&& work) {
    Times own, other;
    for (auto _ : state) {
        other += peer.simplify();
        const Times t = timed(work);
        own += t;
        state.SetIterationTime(t.wall);
    }
    state.counters["ratio"] = own.wall / other.wall;
    state.counters["cpu_ratio"] = own.cpu / other.cpu;
    state.counters["meshopt_ms"] = 1e3 * other.cpu / static_cast<double>(state.iterations());
}

} // namespace wm3d::bench
