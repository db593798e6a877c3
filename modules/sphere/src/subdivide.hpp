// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The icosahedron and its recursive subdivision (section 2.2.1).
#pragma once

#include <vector>

#include <wm3d/mesh/types.hpp>

namespace wm3d::sphere {

/// Its 12 vertices on the unit sphere.
std::vector<Vec3> icosahedron_vertices();

/// Its 20 faces, oriented outwards.
std::vector<Triangle> icosahedron_faces();

/// Faces of the next level; the projected midpoints of all edges are appended to `vertices`.
/// \pre  closed, oriented, no vertex with more than six neighbours
std::vector<Triangle> subdivide(const std::vector<Triangle>& faces, std::vector<Vec3>& vertices);

} // namespace wm3d::sphere
