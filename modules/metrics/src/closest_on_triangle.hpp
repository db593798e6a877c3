// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Closest point of one triangle.
#pragma once

#include <wm3d/mesh/types.hpp>

namespace wm3d::metrics {

/// Barycentric coordinates of the point of triangle a b c that is closest to p; never NaN for finite corners.
Vec3 closest_on_triangle(const Vec3& p, const Vec3& a, const Vec3& b, const Vec3& c);

} // namespace wm3d::metrics
