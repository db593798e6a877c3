// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Curvature of triangle meshes at chosen scales.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>

#include "edge_graph.hpp"

namespace wm3d::metrics {

/// One value per scale.
using PerScale = std::array<double, 3>;

/// Mean magnitude of the principal curvatures (|k1| + |k2|) / 2 at every vertex and scale, #V, per unit of
/// length: eigenvalues of the tensor of D. Cohen-Steiner and J.-M. Morvan, "Restricted Delaunay
/// triangulations and normal cycle" (2003),
///     1 / (pi r^2) sum over edges of angle(e) length(e within the ball) e e^T, in the ball of radius r
/// around the vertex, over the edges that a walk outwards from the vertex takes; the eigenvalue of least
/// magnitude belongs to the normal and is left out. Near borders, where the ball holds less than a disc, the
/// figure is too low.
/// \param wanted  vertices, #V, that a curvature is wanted of; empty: of all. The others have 0.
/// \pre  radii > 0, and `bends` are those of the mesh
std::vector<PerScale> curvature_magnitudes(const TriangleMesh& mesh, const EdgeGraph& graph,
                                           const std::vector<Bend>& bends, const PerScale& radii,
                                           std::span<const char> wanted = {});

} // namespace wm3d::metrics
