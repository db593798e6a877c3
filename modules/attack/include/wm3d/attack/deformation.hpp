// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Maps of the whole space: similarity, non-uniform scale, shear, bend.
#pragma once

#include <cstdint>

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::attack {

struct Similarity {
    Mat3 rotation = Mat3::Identity();
    double scale = 1;
    Vec3 translation = Vec3::Zero();
};

/// The benchmark's random similarity: translation per axis uniform in +-5 d (`mean_vertex_distance`),
/// rotation about a uniformly random axis by an angle uniform in [0, 360) degrees, scale uniform in [0.1,
/// 10).
Similarity random_similarity(double d, std::uint64_t seed);

/// p -> scale rotation (p - c) + c + translation, with c the mean of the vertices.
TriangleMesh transform(const TriangleMesh& mesh, const Similarity& similarity);

/// p -> matrix (p - c) + c, with c the mean of the vertices: non-uniform scale and shear.
/// \throw ParameterError  if the matrix is singular
TriangleMesh transform(const TriangleMesh& mesh, const Mat3& matrix);

/// Bends the longest side of the bounding box into an arc of `degrees`, towards the second longest side.
/// Lengths in the middle of the box are kept (A. Barr, "Global and local deformations of solid primitives",
/// 1984).
/// \pre  |degrees| <= 90, so that no part of the box folds over
TriangleMesh bend(const TriangleMesh& mesh, double degrees);

} // namespace wm3d::attack
