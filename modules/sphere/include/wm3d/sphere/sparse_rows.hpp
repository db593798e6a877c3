// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The matrix B of barycentric weights, by which the linear part of Delta is B w.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <wm3d/sphere/icosphere.hpp>

namespace wm3d::sphere {

/// A matrix with three entries per row.
struct SparseRows {
    std::size_t columns = 0;                    ///< #vertices of the sphere
    std::vector<Triangle> indices;              ///< #rows by 3: columns of the entries
    std::vector<std::array<double, 3>> weights; ///< #rows by 3: the entries; >= 0, each row sums to 1

    std::size_t rows() const { return indices.size(); }
};

/// B for the given directions: row i weighs the three sphere vertices around direction i. In parallel.
SparseRows barycentric_rows(const Icosphere& sphere, std::span<const Vec3> directions);

/// B for the given directions at each of `levels`, none finer than the sphere's, in one descent to the finest of
/// them. In parallel.
/// \throw ParameterError if a level is finer than the sphere
std::vector<SparseRows> barycentric_rows(const Icosphere& sphere, std::span<const Vec3> directions,
                                         std::span<const unsigned> levels);

/// B w, #rows.
/// \pre  w.size() == matrix.columns
std::vector<double> multiply(const SparseRows& matrix, std::span<const double> w);

/// B^T y, #columns, summed in the order of the rows.
/// \pre  y.size() == matrix.rows()
std::vector<double> multiply_transposed(const SparseRows& matrix, std::span<const double> y);

} // namespace wm3d::sphere
