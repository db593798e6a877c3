// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The cotangent Laplacian of a surface, row by row.
#pragma once

#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::detect {

/// A symmetric matrix by rows: the diagonal, and what stands beside it, ascending.
template<typename Value>
struct SymmetricRowsOf {
    std::vector<Value> diagonal; ///< #rows
    std::vector<Index> start;    ///< #rows + 1
    std::vector<Index> column;
    std::vector<Value> value;
};

using SymmetricRows = SymmetricRowsOf<double>;

/// Half cotangents at the edges, clamped so that the matrix stays positive; any triangles. Sums are made in double.
/// \param multiple  every row is filled up to a multiple of so many entries by zeros, whose column is the row's own
template<typename Value>
SymmetricRowsOf<Value> cotangent_laplacian(const TriangleMesh& mesh, Index multiple = 1);

extern template SymmetricRowsOf<float> cotangent_laplacian(const TriangleMesh&, Index);
extern template SymmetricRowsOf<double> cotangent_laplacian(const TriangleMesh&, Index);

} // namespace wm3d::detect
