// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/attack/smoothing.hpp>

#include <utility>

#include <wm3d/mesh/umbrella.hpp>

namespace wm3d::attack {

TriangleMesh smooth_laplacian(const TriangleMesh& mesh, int steps, double lambda) {
    return {Umbrella(mesh).smooth(mesh.positions, steps, lambda), mesh.triangles};
}

TriangleMesh smooth_taubin(const TriangleMesh& mesh, const TaubinOptions& options) {
    const Umbrella umbrella(mesh);
    TriangleMesh result = mesh;
    for (int step = 0; step < options.steps; ++step)
        for (double weight : {options.lambda, options.mu})
            result.positions = umbrella.smooth(std::move(result.positions), 1, weight);
    return result;
}

} // namespace wm3d::attack
