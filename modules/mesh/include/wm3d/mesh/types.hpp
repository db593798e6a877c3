// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Scalars and small vectors.
#pragma once

#include <array>
#include <cstdint>
#include <limits>

#include <Eigen/Core>
#include <Eigen/Geometry>

namespace wm3d {

using Vec3 = Eigen::Vector3d;
using Mat3 = Eigen::Matrix3d;

/// Number of a vertex or a triangle.
using Index = std::uint32_t;
inline constexpr Index no_index = std::numeric_limits<Index>::max();

/// Corners of a triangle, counter-clockwise seen from outside.
using Triangle = std::array<Index, 3>;

/// A point of a triangulated surface: a triangle and barycentric coordinates of its three corners
/// (>= 0, summing to 1).
struct SurfacePoint {
    Index triangle = no_index;
    Vec3 barycentric = Vec3::Zero();
};

} // namespace wm3d
