// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The canonical frame: where the watermarking sphere is placed (section 2.2.2 of the paper puts it at
/// the barycentre; principal axes and scale are this project's, so that moved copies are found blind).
#pragma once

#include <array>

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d {

/// Similarity transform to the canonical frame: q = axes (p - centroid) / scale.
struct Frame {
    Vec3 centroid = Vec3::Zero();
    Mat3 axes = Mat3::Identity(); ///< rows are the frame's axes in the coordinates of the mesh; a rotation
    double scale = 1;             ///< mean radius, in units of the mesh

    Vec3 to_canonical(const Vec3& p) const { return axes * (p - centroid) / scale; }
    Vec3 from_canonical(const Vec3& q) const { return centroid + scale * (axes.transpose() * q); }
};

/// Exact moments of a surface of unit density.
struct SurfaceMoments {
    double area = 0;
    Vec3 centroid = Vec3::Zero();
    Mat3 covariance = Mat3::Zero(); ///< second central moments over area, in squared units of the mesh
};

/// Moments by exact integration over the triangles (they don't depend on how the surface is triangulated).
/// \throw GeometryError  if the surface has no area
SurfaceMoments surface_moments(const TriangleMesh& mesh);

/// Area-weighted mean distance of the surface from `centre`, by a fixed rule of degree 5 on each triangle.
double mean_radius(const TriangleMesh& mesh, const Vec3& centre);

/// The canonical frame: area-weighted centroid, principal axes of the surface's second moments from largest
/// to smallest, mean radius 1. Signs of the first two axes make the third moments along them positive; the
/// third axis completes a right-handed system.
/// \throw GeometryError  if the surface has no area or all of it lies in one point
Frame canonical_frame(const TriangleMesh& mesh);

/// `frame` and its three turns by 180 degrees about its own axes: the four proper choices of axis signs.
/// The first is `frame` itself.
std::array<Frame, 4> sign_choices(const Frame& frame);

/// The mesh in the frame's coordinates.
TriangleMesh to_frame(const TriangleMesh& mesh, const Frame& frame);

} // namespace wm3d
