// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  What a trip through another file format does: nothing but the order changes.
#pragma once

#include <cstdint>

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::attack {

/// The same surface with vertices, triangles and the first corner of every triangle in random order.
TriangleMesh reorder(const TriangleMesh& mesh, std::uint64_t seed);

} // namespace wm3d::attack
