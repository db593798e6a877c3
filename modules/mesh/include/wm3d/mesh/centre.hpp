// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The mean of the vertices: where published attacks and signal-to-noise ratios have the middle of a mesh.
#pragma once

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d {

/// In units of the file.
/// \pre  the mesh has a vertex
Vec3 vertex_mean(const TriangleMesh& mesh);

} // namespace wm3d
