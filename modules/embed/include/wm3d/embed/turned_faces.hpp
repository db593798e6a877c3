// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Faces that a mark would turn over, and moves that leave them.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::embed {

/// A triangle whose least height is a smaller part of its longest edge is a sliver: the slightest move may turn
/// it over, and nobody sees it.
inline constexpr double sliver_shape = 0.05;

/// Triangles, slivers excepted, whose normal points backwards after the move.
/// \param moved  #V
std::vector<Index> turned_faces(const TriangleMesh& mesh, std::span<const Vec3> moved);

/// Takes the moves of the corners of such triangles back by halves until none is left.
/// \param moved  #V
/// \return how many vertices moved less
std::size_t turn_back(const TriangleMesh& mesh, std::vector<Vec3>& moved);

} // namespace wm3d::embed
