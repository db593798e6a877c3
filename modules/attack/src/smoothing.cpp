// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/attack/smoothing.hpp>

#include <wm3d/mesh/parallel.hpp>

#include "neighbours.hpp"

namespace wm3d::attack {

namespace {

constexpr std::size_t block = 8192;

/// One simultaneous step: to[v] = from[v] + weight U(v); borders and isolated vertices are copied.
void umbrella_step(const Neighbours& neighbours, double weight, const std::vector<Vec3>& from,
                   std::vector<Vec3>& to) {
    parallel_blocks(from.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
            to[v] = from[v];
            const auto ring = neighbours.of(v);
            if (ring.empty() || neighbours.on_border(v))
                continue;
            Vec3 sum = Vec3::Zero();
            for (Index w : ring)
                sum += from[w];
            to[v] += weight * (sum / static_cast<double>(ring.size()) - from[v]);
        }
    });
}

/// `steps` rounds, each with one umbrella step per weight.
TriangleMesh smooth(const TriangleMesh& mesh, int steps, const std::vector<double>& weights) {
    const Neighbours neighbours(mesh);
    TriangleMesh result = mesh;
    std::vector<Vec3> previous(mesh.positions.size());
    for (int step = 0; step < steps; ++step)
        for (double weight : weights) {
            previous.swap(result.positions);
            umbrella_step(neighbours, weight, previous, result.positions);
        }
    return result;
}

} // namespace

TriangleMesh smooth_laplacian(const TriangleMesh& mesh, int steps, double lambda) {
    return smooth(mesh, steps, {lambda});
}

TriangleMesh smooth_taubin(const TriangleMesh& mesh, const TaubinOptions& options) {
    return smooth(mesh, options.steps, {options.lambda, options.mu});
}

} // namespace wm3d::attack
