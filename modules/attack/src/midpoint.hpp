// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Midpoint subdivision.
#pragma once

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::attack {

/// Cuts each triangle in four at the middles of its edges; works on any topology and keeps the surface.
TriangleMesh subdivide_midpoint(const TriangleMesh& mesh);

} // namespace wm3d::attack
