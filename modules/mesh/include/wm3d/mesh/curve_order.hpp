// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Meshes along a space-filling curve: what is close on the surface is close in memory.
#pragma once

#include <cstdint>
#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d {

inline constexpr int morton_bits = 11; ///< of a Morton code, per axis

/// Place on the Morton curve of a point of the cube from -1/2 to 1/2; points outside count as its nearest.
std::uint64_t morton_code(const Vec3& unit);

/// A mesh in another order.
struct Reordered {
    TriangleMesh mesh;
    std::vector<Index> original; ///< number of each vertex in the mesh that was given, #V
};

/// The mesh with its vertices along a Morton curve and its triangles by their first vertex on it. Work that
/// goes from vertex to neighbouring vertex takes half of the time on large meshes that come in another order.
Reordered along_curve(const TriangleMesh& mesh);

} // namespace wm3d
