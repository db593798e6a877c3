// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Curvature of triangle meshes at a chosen scale.
#pragma once

#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>

#include "vertex_adjacency.hpp"

namespace wm3d::metrics {

/// Mean magnitude of the principal curvatures (|k1| + |k2|) / 2 at every vertex, #V, per unit of length:
/// eigenvalues of the tensor of D. Cohen-Steiner and J.-M. Morvan, "Restricted Delaunay triangulations and
/// normal cycle" (2003),
///     1 / (pi r^2) sum over edges of angle(e) length(e within the ball) e e^T,
/// in the ball of radius r around the vertex; the eigenvalue of least magnitude belongs to the normal and is
/// left out. Near borders, where the ball holds less than a disc, the figure is too low. \pre  radius > 0
std::vector<double> curvature_magnitude(const TriangleMesh& mesh, const VertexAdjacency& adjacency,
                                        double radius);

} // namespace wm3d::metrics
