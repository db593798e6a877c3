// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Plane faces of a surface: where a cut may have been closed again.
#pragma once

#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::search {

/// Triangles that lie in one plane, connected or not.
struct Flat {
    double area = 0;            ///< relative to the surface
    Vec3 centre = Vec3::Zero(); ///< of the area
    Vec3 normal = Vec3::Zero(); ///< unit length, as its triangles face
};

/// The plane faces that have at least about 0.6 % of the surface, the largest first. They are found by 512 places
/// spread evenly over the area, so much smaller ones may be among them or not.
std::vector<Flat> flats(const TriangleMesh& mesh);

/// The one plane face of a surface that has no other to speak of; of no area if there is none. A model of many
/// plane faces was made with them. A cut that was closed leaves one in a surface that is nowhere else plane.
Flat lone_flat(const TriangleMesh& mesh);

} // namespace wm3d::search
