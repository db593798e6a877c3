// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/attack/perturbation.hpp>

#include <cmath>

#include <wm3d/attack/random.hpp>
#include <wm3d/core/parallel.hpp>
#include <wm3d/mesh/centre.hpp>
#include <wm3d/mesh/measure.hpp>
#include <wm3d/mesh/neighbours.hpp>

namespace wm3d::attack {

namespace {

constexpr std::size_t block = 16384;

/// Calls move(v, position) for every vertex.
template<typename Move>
TriangleMesh moved(const TriangleMesh& mesh, Move&& move) {
    TriangleMesh result = mesh;
    parallel_blocks(result.positions.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v)
            move(v, result.positions[v]);
    });
    return result;
}

} // namespace

double mean_vertex_distance(const TriangleMesh& mesh) {
    if (mesh.positions.empty())
        return 0;
    const Vec3 centre = vertex_mean(mesh);
    const double sum = parallel_sum_of(mesh.positions.size(), block,
                                       [&](std::size_t v) { return (mesh.positions[v] - centre).norm(); });
    return sum / static_cast<double>(mesh.positions.size());
}

TriangleMesh add_noise(const TriangleMesh& mesh, double percent, std::uint64_t seed) {
    const double amplitude = percent / 100 * mean_vertex_distance(mesh);
    const std::vector<char> border = border_vertices(mesh);
    const RandomStream random(seed, 0);
    return moved(mesh, [&](std::size_t v, Vec3& p) {
        if (border[v])
            return;
        for (int k = 0; k < 3; ++k)
            p[k] += random.between(3 * v + static_cast<std::size_t>(k), -amplitude, amplitude);
    });
}

TriangleMesh quantize(const TriangleMesh& mesh, int bits) {
    const Box box = bounding_box(mesh.positions);
    const Vec3 step = (box.max - box.min) / std::exp2(bits);
    return moved(mesh, [&](std::size_t, Vec3& p) {
        for (int k = 0; k < 3; ++k)
            if (step[k] > 0)
                p[k] = box.min[k] + step[k] * std::round((p[k] - box.min[k]) / step[k]);
    });
}

TriangleMesh round_decimals(const TriangleMesh& mesh, int decimals) {
    const double levels = std::pow(10.0, decimals);
    return moved(mesh, [&](std::size_t, Vec3& p) {
        for (int k = 0; k < 3; ++k)
            p[k] = std::round(p[k] * levels) / levels;
    });
}

} // namespace wm3d::attack
