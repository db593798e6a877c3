// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  A surface reduced to a few points with normals: enough to find its pose again.
#pragma once

#include <cstddef>
#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>
#include <wm3d/resync/similarity.hpp>

namespace wm3d::resync {

/// Points spread evenly over a surface, with the surface's normals there.
struct PoseTemplate {
    std::vector<Vec3> points;  ///< #points
    std::vector<Vec3> normals; ///< #points, of length 1
};

/// Samples a surface by its area: point k stands at the part (k + 1/2) / count of the area, in the order of
/// the triangles. On a mesh that `simplify` made, whose triangles follow a space-filling curve, the points
/// are spread evenly.
/// \throw GeometryError if the surface has no area
/// \throw ParameterError if count is 0
PoseTemplate make_template(const TriangleMesh& mesh, std::size_t count);

/// The template of the moved surface.
PoseTemplate moved(const PoseTemplate& pose_template, const Similarity& t);

} // namespace wm3d::resync
