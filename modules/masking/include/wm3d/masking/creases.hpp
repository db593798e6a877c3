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
    /// \param normals  unit, #V, along which vertices move
    Creases(const TriangleMesh& mesh, std::span<const Vec3> normals);

    /// Takes back what folds a crease: projects the moves on one hinge's limits after the other (S. Kaczmarz 1937),
    /// by the least change relative to the moves, until all keep to theirs, to first order in the moves. What
    /// doesn't move stays.
    /// \param moves  #V, in units of the mesh
    void limit(std::vector<double>& moves, const CreaseOptions& options = {}) const;

    /// The largest turn that moves make of any hinge, as a part of what it may turn, to first order.
    double worst(std::span<const double> moves, const CreaseOptions& options = {}) const;

private:
    struct Hinge {
        std::array<Index, 4> vertices;
        std::array<double, 4> turns; ///< radians per move of each
        double angle;                ///< radians, between the triangles
    };

    void add(const TriangleMesh& mesh, std::span<const Vec3> normals, const std::array<Index, 4>& vertices);
    double turn(const Hinge& hinge, std::span<const double> moves) const;
    std::vector<Index> turned_too_far(std::span<const double> moves, const CreaseOptions& options) const;
    std::vector<Index> around(std::span<const Index> hinges) const;

    std::vector<Hinge> hinges_;
    std::vector<Index> first_, at_vertex_; ///< hinges of vertex v: at_vertex_[first_[v]] up to first_[v + 1]
};

/// Moved positions of the mesh, #V, whose moves along the normals fold no crease any more.
/// \param creases  of the mesh and its normals
/// \param normals  unit, #V
std::vector<Vec3> without_creases(const Creases& creases, const TriangleMesh& mesh,
                                  std::span<const Vec3> normals, std::vector<Vec3> moved,
                                  const CreaseOptions& options = {});

} // namespace wm3d::masking
