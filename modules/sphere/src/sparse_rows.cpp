// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/sphere/sparse_rows.hpp>

#include <wm3d/mesh/parallel.hpp>

namespace wm3d::sphere {

SparseRows barycentric_rows(const Icosphere& sphere, std::span<const Vec3> directions) {
    SparseRows matrix{sphere.vertices().size(), std::vector<Triangle>(directions.size()),
                      std::vector<std::array<double, 3>>(directions.size())};
    parallel_blocks(directions.size(), 1024, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const SphereLocation at = sphere.locate(directions[i]);
            matrix.indices[i] = at.vertices;
            matrix.weights[i] = {at.barycentric[0], at.barycentric[1], at.barycentric[2]};
        }
    });
    return matrix;
}

std::vector<double> multiply(const SparseRows& matrix, std::span<const double> w) {
    std::vector<double> result(matrix.rows());
    parallel_blocks(result.size(), 16384, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const auto& [a, b, c] = matrix.indices[i];
            const auto& weights = matrix.weights[i];
            result[i] = weights[0] * w[a] + weights[1] * w[b] + weights[2] * w[c];
        }
    });
    return result;
}

std::vector<double> multiply_transposed(const SparseRows& matrix, std::span<const double> y) {
    std::vector<double> result(matrix.columns, 0.0);
    for (std::size_t i = 0; i < matrix.rows(); ++i)
        for (std::size_t k = 0; k < 3; ++k)
            result[matrix.indices[i][k]] += matrix.weights[i][k] * y[i];
    return result;
}

} // namespace wm3d::sphere
