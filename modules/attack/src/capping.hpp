// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Closing a planar cut.
#pragma once

#include <array>
#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::attack {

/// Adds triangles that fill the outline of a planar cut, holes left out (even-odd rule), by a constrained
/// Delaunay triangulation in the plane; no vertices are added. `outline` holds directed segments between
/// vertices of the mesh, `normal` is the outward normal of the cap.
/// \throw GeometryError  if segments of the outline cross
void cap(TriangleMesh& mesh, const std::vector<std::array<Index, 2>>& outline, const Vec3& normal);

} // namespace wm3d::attack
