// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The canonical frame: where the watermarking sphere is placed (section 2.2.2 of the paper puts it at
/// the barycentre; principal axes and scale are this project's, so that moved copies are found blind).
#pragma once

#include <array>
#include <vector>

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

/// Exact moments of the solid of unit density that a surface encloses. Noise and roundings move a surface in
/// and out alike and so leave these alone, where they add area to whatever is finely sampled.
struct SolidMoments {
    double volume = 0; ///< signed: negative where the triangles look inwards
    Vec3 centroid = Vec3::Zero();
    Mat3 covariance = Mat3::Zero(); ///< second central moments over volume, in squared units of the mesh
    double sphericity = 0;          ///< 36 pi volume^2 / area^3: 1 of a sphere, 0 of a sheet
    double openness = 0; ///< length of the sum of the area vectors over area: 0 of a closed surface
};

/// An open surface is closed by a cone whose apex is the centroid itself. Without volume all is zero.
/// \throw GeometryError  if the surface has no area
SolidMoments solid_moments(const TriangleMesh& mesh);

/// What a canonical frame is taken from.
enum class Substance {
    solid,   ///< what the surface encloses
    surface, ///< the surface itself: sheets, scans with large holes, triangles that look both ways
};

/// Centre and spread of a mass: what a canonical frame's place and axes come from.
struct CentralMoments {
    Vec3 centroid = Vec3::Zero();
    Mat3 covariance = Mat3::Zero(); ///< second central moments over mass, in squared units of the mesh
};

/// Moments of both substances of a mesh.
struct ShapeMoments {
    SurfaceMoments surface;
    SolidMoments solid;

    /// That of the mesh: a solid where it encloses enough and is closed enough.
    Substance substance() const;

    /// Both, that of the mesh first, where an attack could have turned one into the other; else its own.
    std::vector<Substance> possible_substances() const;

    CentralMoments of(Substance substance) const;
    CentralMoments own() const { return of(substance()); }
};

/// \throw GeometryError  if the surface has no area
ShapeMoments shape_moments(const TriangleMesh& mesh);

/// `shape_moments(mesh).of(substance)`, without what the other substance alone would take.
/// \throw GeometryError  if the surface has no area
CentralMoments central_moments(const TriangleMesh& mesh, Substance substance);

/// Eigenvectors of a covariance as rows, from the largest eigenvalue to the smallest; a rotation, whose first two rows
/// may have either sign.
Mat3 principal_axes(const Mat3& covariance);

/// Area-weighted mean distance of the surface from `centre`, by a fixed rule of degree 5 on each triangle.
double mean_radius(const TriangleMesh& mesh, const Vec3& centre);

/// The frame of a mass: its centroid and its principal axes, from the largest second moment to the smallest;
/// mean radius of the surface 1. Signs of the first two axes make the surface's third moments along them
/// positive; the third axis completes a right-handed system.
/// \throw GeometryError if all of the surface lies in the centroid
Frame principal_frame(const TriangleMesh& mesh, const CentralMoments& moments);

/// The canonical frame: the principal frame of a substance.
/// \throw GeometryError  if the surface has no area or all of it lies in one point
Frame canonical_frame(const TriangleMesh& mesh, Substance substance);

/// The canonical frame of the mesh's own substance.
Frame canonical_frame(const TriangleMesh& mesh);

/// `frame` and its three turns by 180 degrees about its own axes: the four proper choices of axis signs.
/// The first is `frame` itself.
std::array<Frame, 4> sign_choices(const Frame& frame);

/// The mesh in the frame's coordinates.
TriangleMesh to_frame(const TriangleMesh& mesh, const Frame& frame);

} // namespace wm3d
