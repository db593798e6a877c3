// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/detect/cell_samples.hpp>

#include <algorithm>
#include <cmath>

#include <wm3d/mesh/measure.hpp>

namespace wm3d::detect {

namespace {

/// Barycentric coordinates of the centres of the n^2 parts that n - 1 cuts along each side make of a
/// triangle.
std::vector<std::array<double, 3>> centres_of_parts(int n) {
    std::vector<std::array<double, 3>> centres;
    const auto add = [&](double u, double v) { centres.push_back({1 - (u + v) / n, u / n, v / n}); };
    for (int u = 0; u < n; ++u)
        for (int v = 0; u + v < n; ++v) {
            add(u + 1.0 / 3, v + 1.0 / 3);
            if (u + v + 1 < n)
                add(u + 2.0 / 3, v + 2.0 / 3);
        }
    return centres;
}

} // namespace

CellSamples::CellSamples(const TriangleMesh& mesh, std::size_t count) {
    const double per_triangle = static_cast<double>(count) / static_cast<double>(mesh.triangles.size());
    const auto centres = centres_of_parts(std::max(1, static_cast<int>(std::ceil(std::sqrt(per_triangle)))));
    const std::vector<double> area = triangle_areas(mesh);
    std::vector<double> total(mesh.positions.size(), 0.0);
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
        for (const std::array<double, 3>& b : centres) {
            const Triangle& t = mesh.triangles[f];
            positions_.push_back(b[0] * mesh.positions[t[0]] + b[1] * mesh.positions[t[1]] +
                                 b[2] * mesh.positions[t[2]]);
            corners_.push_back(t);
            std::array<double, 3>& share = shares_.emplace_back();
            for (std::size_t k = 0; k < 3; ++k) {
                share[k] = area[f] * b[k] * b[k] * b[k];
                total[t[k]] += share[k];
            }
        }
    for (std::size_t s = 0; s < shares_.size(); ++s)
        for (std::size_t k = 0; k < 3; ++k)
            if (const double sum = total[corners_[s][k]]; sum > 0)
                shares_[s][k] /= sum;
}

std::vector<double> CellSamples::spread(std::span<const double> y) const {
    std::vector<double> result(positions_.size());
    for (std::size_t s = 0; s < result.size(); ++s)
        for (std::size_t k = 0; k < 3; ++k)
            result[s] += shares_[s][k] * y[corners_[s][k]];
    return result;
}

} // namespace wm3d::detect
