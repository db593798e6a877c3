// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The peer that timings are ratios against: meshopt_simplify, bringing the same model to 10,000
/// vertices.
#pragma once

#include <chrono>
#include <cstdlib>
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

template<typename Work>
double seconds(Work&& work) {
    const auto start = std::chrono::steady_clock::now();
    work();
    return std::chrono::duration<double>(std::chrono::steady_clock::now() - start).count();
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

    /// Seconds that one simplification takes.
    double simplify() const {
        std::vector<unsigned> result(indices_.size());
        return seconds([&] {
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

/// Runs the peer and `work` in turn; reports the time of `work`, and the ratio of the sums as a counter.
template<typename Work>
void ratio(::benchmark::State& state, const Peer& peer, Work&& work) {
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

} // namespace wm3d::bench
