// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/sphere/sparse_rows.hpp>

#include <algorithm>
#include <utility>

#include <fmt/format.h>

#include <wm3d/core/error.hpp>
#include <wm3d/core/parallel.hpp>

namespace wm3d::sphere {

namespace {

SparseRows empty_rows(unsigned level, std::size_t rows) {
    return {10 * (std::size_t{1} << (2 * level)) + 2, std::vector<Triangle>(rows),
            std::vector<std::array<double, 3>>(rows)};
}

/// The rows from `begin` on, at the level that the directions have come to.
void set_rows(SparseRows& matrix, std::size_t begin, std::size_t end, const Descent& at) {
    for (std::size_t i = begin; i < end; ++i) {
        const Vec3 weights = at.weights(i - begin);
        matrix.indices[i] = at.corners(i - begin);
        matrix.weights[i] = {weights[0], weights[1], weights[2]};
    }
}

} // namespace

SparseRows barycentric_rows(const Icosphere& sphere, std::span<const Vec3> directions) {
    const unsigned level = sphere.level();
    return std::move(barycentric_rows(sphere, directions, std::span(&level, 1)).front());
}

std::vector<SparseRows> barycentric_rows(const Icosphere& sphere, std::span<const Vec3> directions,
                                         std::span<const unsigned> levels) {
    std::vector<SparseRows> matrices;
    for (unsigned level : levels) {
        if (level > sphere.level())
            throw ParameterError(
                fmt::format("level {} is finer than the sphere, which has level {}", level, sphere.level()));
        matrices.push_back(empty_rows(level, directions.size()));
    }
    parallel_blocks(levels.empty() ? 0 : directions.size(), 1024, [&](std::size_t begin, std::size_t end) {
        Descent descent(sphere, directions.subspan(begin, end - begin));
        for (;; descent.refine()) {
            for (std::size_t l = 0; l < levels.size(); ++l)
                if (levels[l] == descent.level())
                    set_rows(matrices[l], begin, end, descent);
            if (descent.level() == std::ranges::max(levels))
                return;
        }
    });
    return matrices;
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
