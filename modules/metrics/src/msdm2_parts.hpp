// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  What MSDM2 is put together from, whether meshes are looked at whole or in patches.
#pragma once

#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>

#include "curvature.hpp"

namespace wm3d::metrics {

/// S of a mesh: the longest side of its box.
double longest_side(const TriangleMesh& mesh);

inline PerScale times(double factor, const PerScale& values) {
    return {factor * values[0], factor * values[1], factor * values[2]};
}

/// Values at a triangle's corners, each weighted by the area that `p` spans with the side opposite.
PerScale blend(const TriangleMesh& mesh, Index triangle, const std::vector<PerScale>& values, const Vec3& p);

/// At most `most` of vertices, one in a power of two, which of a mesh `along_curve` leaves one of each cell.
/// \pre  most > 0
std::vector<Index> some_of(const std::vector<Index>& vertices, std::size_t most);

/// Of local distances.
double minkowski_mean(const std::vector<double>& local, double exponent);

} // namespace wm3d::metrics
