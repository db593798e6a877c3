// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Equations (1) and (2) of the paper.
#pragma once

#include <array>

#include <wm3d/mesh/types.hpp>

namespace wm3d::maps {

/// Corners of a triangle in space.
using Corners = std::array<Vec3, 3>;

/// Equation (1): the point of the triangle (p_i, p_j, p_k) of the base domain with barycentric coordinates
/// (alpha, beta, gamma), in units of the mesh.
/// \pre  the coordinates sum to 1
Vec3 base_point(const Corners& base_triangle, const Vec3& barycentric);

/// Barycentric coordinates of the point of the triangle's plane nearest to p; negative ones where that lies
/// outside. In a triangle without area the coordinates of the nearest point of its longest side.
Vec3 barycentric_coordinates(const Vec3& p, const Corners& triangle);

/// Equation (2): the point of the original surface that corresponds to the point p of the base domain.
/// `images` are Pi(p_i), Pi(p_j), Pi(p_k), the places on the base domain of the corners `originals` of a
/// triangle of the original, and hold p.
Vec3 original_point(const Vec3& p, const Corners& images, const Corners& originals);

/// The same where the coordinates (alpha, beta, gamma) of p among the images are known already.
Vec3 original_point(const Vec3& barycentric, const Corners& originals);

} // namespace wm3d::maps
