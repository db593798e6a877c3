// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Turning any input into what half-edge libraries accept.
#pragma once

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::attack {

/// The mesh without vertices that no triangle uses; order is kept.
TriangleMesh without_unused_vertices(const TriangleMesh& mesh);

/// An oriented manifold, perhaps with borders and several components, of the same triangles: repeated
/// triangles and those that repeat a corner are dropped, neighbours are oriented alike, and vertices and
/// edges where the surface isn't a manifold are split into copies. A mesh that is one already keeps its
/// order.
/// \throw GeometryError if no triangle is left
TriangleMesh make_manifold(const TriangleMesh& mesh);

} // namespace wm3d::attack
