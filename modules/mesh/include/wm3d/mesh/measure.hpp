// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Areas, normals and extents.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d {

/// Smallest box that holds all points, parallel to the axes.
struct Box {
    Vec3 min = Vec3::Zero();
    Vec3 max = Vec3::Zero();
    double diagonal() const { return (max - min).norm(); }
};

/// Box of the points; of no points, the box of the origin.
Box bounding_box(std::span<const Vec3> points);

/// Box of the vertices that a triangle uses; isolated vertices are left out.
Box surface_box(const TriangleMesh& mesh);

/// Twice the area of triangle f times its unit normal; zero for a degenerate triangle.
inline Vec3 area_vector(const TriangleMesh& mesh, std::size_t f) {
    const Triangle& t = mesh.triangles[f];
    const Vec3& a = mesh.positions[t[0]];
    return (mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a);
}

/// In squared units of the file.
inline double triangle_area(const TriangleMesh& mesh, std::size_t f) {
    return 0.5 * area_vector(mesh, f).norm();
}

/// Area of every triangle, #F, in squared units of the file.
std::vector<double> triangle_areas(const TriangleMesh& mesh);

/// Lumped vertex areas, #V: a third of the area of every triangle around the vertex; 0 where isolated.
std::vector<double> vertex_areas(const TriangleMesh& mesh);

/// Unit vertex normals, #V: area-weighted mean of the triangle normals; zero where isolated or cancelled.
std::vector<Vec3> vertex_normals(const TriangleMesh& mesh);

double surface_area(const TriangleMesh& mesh);

} // namespace wm3d
