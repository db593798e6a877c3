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
template<typename Value>
SymmetricRowsOf<Value> cotangent_laplacian(const TriangleMesh& mesh);

extern template SymmetricRowsOf<float> cotangent_laplacian(const TriangleMesh&);
extern template SymmetricRowsOf<double> cotangent_laplacian(const TriangleMesh&);

} // namespace wm3d::detect
