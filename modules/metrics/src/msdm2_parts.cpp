// SPDX-License-Identifier: GPL-3.0-or-later
#include "msdm2_parts.hpp"

#include <bit>
#include <cmath>

#include <wm3d/core/parallel.hpp>
#include <wm3d/mesh/measure.hpp>

namespace wm3d::metrics {

double longest_side(const TriangleMesh& mesh) {
    const Box box = surface_box(mesh);
    return (box.max - box.min).maxCoeff();
}

PerScale blend(const TriangleMesh& mesh, Index triangle, const std::vector<PerScale>& values, const Vec3& p) {
    const Triangle& t = mesh.triangles[triangle];
    const Vec3 a = mesh.positions[t[0]] - p, b = mesh.positions[t[1]] - p, c = mesh.positions[t[2]] - p;
    const Vec3 areas(b.cross(c).norm(), c.cross(a).norm(), a.cross(b).norm());
    const Vec3 weights = areas / areas.sum();
    PerScale blended{};
    for (std::size_t k = 0; k < blended.size(); ++k)
        blended[k] =
            weights[0] * values[t[0]][k] + weights[1] * values[t[1]][k] + weights[2] * values[t[2]][k];
    return blended;
}

std::vector<Index> some_of(const std::vector<Index>& vertices, std::size_t most) {
    const std::size_t stride = std::bit_ceil((vertices.size() + most - 1) / most);
    std::vector<Index> some;
    for (std::size_t i = 0; i < vertices.size(); i += stride)
        some.push_back(vertices[i]);
    return some;
}

double minkowski_mean(const std::vector<double>& local, double exponent) {
    const double sum =
        parallel_sum_of(local.size(), 1024, [&](std::size_t i) { return std::pow(local[i], exponent); });
    return std::pow(sum / static_cast<double>(local.size()), 1 / exponent);
}

} // namespace wm3d::metrics
