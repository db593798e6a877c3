// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  A triangle mesh whose edges can be flipped.
#pragma once

#include <array>
#include <unordered_set>
#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::attack {

/// Half-edge h = 3 f + k runs from corner k of triangle f to its next corner. Two half-edges are twins where
/// an edge has exactly two triangles and they agree in orientation; all other edges stay as they are.
class Flipper {
public:
    Flipper(const TriangleMesh& mesh, double max_angle_degrees);

    /// One half-edge of every edge that has a twin.
    std::vector<Index> inner_edges() const;

    /// Number of distinct edges; flips keep it.
    std::size_t edge_count() const { return edges_.size(); }

    /// Whether the two angles opposite to the edge sum to at most 180 degrees.
    bool is_delaunay(Index half_edge) const;

    bool may_flip(Index half_edge) const;

    /// Replaces edge a-b of triangles a b c and b a d by edge c-d; returns the half-edges of the four edges
    /// around.
    /// \pre  may_flip(half_edge)
    std::array<Index, 4> flip(Index half_edge);

    TriangleMesh mesh() && { return std::move(mesh_); }

private:
    struct Quad {
        Index a, b, c, d;
    };

    static Index next(Index h) { return h % 3 == 2 ? h - 2 : h + 1; }
    static Index previous(Index h) { return h % 3 == 0 ? h + 2 : h - 1; }
    Index origin(Index h) const { return mesh_.triangles[h / 3][h % 3]; }
    Quad quad(Index h) const;
    bool is_flat(const Quad& q) const;
    void pair(Index h, Index twin);

    TriangleMesh mesh_;
    double min_cosine_;
    std::vector<Index> twin_;
    std::unordered_set<std::uint64_t> edges_; // asked, never iterated
};

} // namespace wm3d::attack
