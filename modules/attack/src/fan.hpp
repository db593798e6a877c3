// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Closing holes in the simplest way.
#pragma once

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::attack {

/// Adds, for each connected set of border edges, the mean of its vertices and a triangle from each edge to
/// it.
TriangleMesh close_with_fans(const TriangleMesh& mesh);

} // namespace wm3d::attack
