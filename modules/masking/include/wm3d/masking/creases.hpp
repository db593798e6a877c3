// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Creases that moves of the vertices would fold into a surface.
#pragma once

#include <array>
#include <cstddef>
#include <span>
#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::masking {

struct CreaseOptions {
    double flat = 0.1;       ///< radians by which two triangles in one plane may turn against each other
    double share = 0.5;      ///< and of the angle that is between them already
    double tolerance = 0.02; ///< of what a hinge may turn
    std::size_t most_rounds = 200; ///< through the hinges that turn too far
};

/// The hinges of a mesh, each an edge and its two triangles, and how far each may turn. MSDM2 looks around
/// vertices, so that it doesn't see a flat side of large triangles being folded along an edge; people do.
class Creases {
public:
    /// \param mesh     any triangles; edges that don't have two triangles with an area are left out
    /// \param normals  unit, #V, along which vertices move; they and the mesh have to outlive the object
    Creases(const TriangleMesh& mesh, std::span<const Vec3> normals);

    /// Takes back what folds a crease: projects the moves on one hinge's limits after the other (S. Kaczmarz 1937),
    /// by the least change relative to the moves, until all keep to theirs, to first order in the moves. What
    /// doesn't move stays.
    /// \param moves  #V, in units of the mesh
    void limit(std::vector<double>& moves, const CreaseOptions& options = {}) const;

    /// The largest turn that moves make of any hinge, as a part of what it may turn, to first order.
    double worst(std::span<const double> moves, const CreaseOptions& options = {}) const;

private:
    /// What a hinge is by the places of its vertices: made where it is asked for, since few are asked for twice.
    struct Hinge {
        std::array<Index, 4> vertices; ///< both ends of the edge, and the corners opposite
        std::array<double, 4> turns{}; ///< radians per move of each; 0 where a triangle has no area
        std::array<Vec3, 2> normals;   ///< of the triangles, unit

        double turn(std::span<const double> moves) const;
        double limit(const CreaseOptions& options) const;
    };

    Hinge hinge(Index h) const;
    std::vector<Index> turned_too_far(std::span<const double> moves, const CreaseOptions& options) const;

    const TriangleMesh& mesh_;
    std::span<const Vec3> normals_;
    std::vector<std::array<Index, 4>> vertices_; ///< of each hinge, as Hinge has them
};

/// Moved positions of the mesh, #V, whose moves along the normals fold no crease any more.
/// \param creases  of the mesh and its normals
/// \param normals  unit, #V
std::vector<Vec3> without_creases(const Creases& creases, const TriangleMesh& mesh,
                                  std::span<const Vec3> normals, std::vector<Vec3> moved,
                                  const CreaseOptions& options = {});

} // namespace wm3d::masking
