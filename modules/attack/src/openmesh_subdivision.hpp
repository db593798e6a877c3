// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The subdivision schemes of OpenMesh.
#pragma once

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::attack {

TriangleMesh subdivide_loop(const TriangleMesh& mesh, int steps);
TriangleMesh subdivide_sqrt3(const TriangleMesh& mesh, int steps);

} // namespace wm3d::attack
