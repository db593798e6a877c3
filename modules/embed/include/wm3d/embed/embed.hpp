// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Embedding in the base domain and reconstruction of the full mesh (sections 2.2.2 and 2.2.3).
#pragma once

#include <span>
#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::embed {

/// Radius of a marked base vertex: r + gamma Delta, eq. (3).
constexpr double marked_radius(double radius, double gamma, double delta) {
    return radius + gamma * delta;
}

/// Moves each base vertex along its own direction from the origin to `marked_radius`; eq. (3). A vertex at
/// the origin has no direction and stays.
/// \param base   #base positions in the canonical frame
/// \param delta #base values R_P - R
std::vector<Vec3> mark_base(std::span<const Vec3> base, std::span<const double> delta, double gamma);

/// A mesh over its base domain: each vertex has a place p on a base triangle and a detail vector t = P - p
/// (section 2.2.3).
class DetailedMesh {
public:
    /// \param mesh   the full mesh, in the canonical frame
    /// \param base   the base domain, in the same frame
    /// \param place  #V places of the vertices on the base domain; no_index for isolated vertices, which stay
    /// \throw ParameterError  if the sizes disagree
    DetailedMesh(const TriangleMesh& mesh, const TriangleMesh& base, std::span<const SurfacePoint> place);

    /// P_w = t + p_w for the moved base vertices: #V positions. Vertices whose triangle did not move keep
    /// their exact position.
    std::vector<Vec3> reconstruct(std::span<const Vec3> moved_base) const;

private:
    const TriangleMesh& base_;
    std::vector<Vec3> position_, detail_;
    std::vector<SurfacePoint> place_;
};

/// How far a mark moved a mesh.
struct Distortion {
    double normal_rms = 0; ///< area-weighted root mean square of the move along the vertex normals
    double vertex_rms = 0; ///< root mean square distance over the vertices
    double max = 0;        ///< largest distance of a vertex
};

/// Distortion between a mesh and its vertices' new positions, in units of the mesh.
Distortion distortion(const TriangleMesh& mesh, std::span<const Vec3> moved);

/// The same where the mesh's `vertex_normals` are known.
Distortion distortion(const TriangleMesh& mesh, std::span<const Vec3> moved, std::span<const Vec3> normals);

} // namespace wm3d::embed
