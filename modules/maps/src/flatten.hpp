// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Conformal flattening of the ring of a vertex.
#pragma once

#include <span>
#include <vector>

#include <wm3d/mesh/types.hpp>

namespace wm3d::maps {

using Vec2 = Eigen::Vector2d;

/// Twice the signed area of the triangle between a and b.
inline double cross(const Vec2& a, const Vec2& b) {
    return a[0] * b[1] - a[1] * b[0];
}

/// The neighbours of a vertex in the plane, the vertex itself at the origin: the triangles laid out one after
/// the other around it, then z -> z^a with a = 2 pi / (angle sum), or pi / (angle sum) for an open ring. The
/// first lies on the positive x axis, the last of an open ring exactly on the negative. Lengths are in units
/// of the longest spoke. Where all angles vanish, they are taken as equal.
/// \param ring   the neighbours counter-clockwise, relative to the vertex
/// \param plane  receives one point per neighbour
void flatten(std::span<const Vec3> ring, bool closed, std::vector<Vec2>& plane);

} // namespace wm3d::maps
