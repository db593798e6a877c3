// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Cutting a part of the model off.
#pragma once

#include <cstdint>
#include <optional>

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::attack {

struct CropOptions {
    double percent = 30;        ///< of the surface's vertices that are removed, in (0, 100)
    std::optional<Vec3> normal; ///< direction in which the removed part lies; random where not given
    bool cap = false;           ///< close the cut with flat triangles
};

/// Removes what lies beyond a plane that leaves `percent` % of the vertices behind it. Triangles that cross
/// the plane are cut (this project's own clipping): one new vertex for each cut edge, shared by both
/// triangles of the edge. The share is met to one vertex unless several vertices lie in the same plane across
/// `normal`.
/// \throw ParameterError if the percentage is outside (0, 100) or the normal is zero
/// \throw GeometryError if nothing would be left, or if the cut is to be closed and its outline crosses
///        itself
TriangleMesh crop(const TriangleMesh& mesh, const CropOptions& options, std::uint64_t seed);

} // namespace wm3d::attack
