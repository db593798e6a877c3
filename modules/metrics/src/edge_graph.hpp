// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The edges of a mesh, whatever its topology, and where they lead from each vertex.
#pragma once

#include <span>
#include <vector>

#include <wm3d/core/filed.hpp>
#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::metrics {

/// Follows from the triangles alone: meshes of the same triangles share it.
class EdgeGraph {
public:
    struct Edge {
        Index a = 0, b = 0; ///< a < b
        /// The triangle that walks from a to b and the one that walks back; `no_index` for both where the
        /// edge hasn't exactly these two: at borders, where three meet, and where orientations disagree.
        Index left = no_index, right = no_index;
    };

    /// An edge as seen from one of its ends.
    struct Way {
        Index to = 0;
        Index edge = 0; ///< its number
    };

    EdgeGraph() = default;
    explicit EdgeGraph(const TriangleMesh& mesh) { assign(mesh); }

    /// To those of another mesh, in the memory that this one has.
    void assign(const TriangleMesh& mesh);

    std::span<const Edge> edges() const& { return edges_; }
    std::span<const Edge> edges() && = delete; // would outlive what it shows

    /// Edges at a vertex, ascending.
    std::span<const Way> ways_from(std::size_t vertex) const { return ways_.under(vertex); }

    /// Triangles at a vertex, ascending.
    std::span<const Index> triangles_at(std::size_t vertex) const { return triangles_.under(vertex); }

private:
    void file_triangles(const TriangleMesh& mesh);
    void list_edges(const TriangleMesh& mesh);
    void file_ways(std::size_t vertices);

    std::vector<Edge> edges_;
    Filed<Way> ways_;
    Filed<Index> triangles_;
};

/// How the surface turns along an edge.
struct Bend {
    double angle_per_length = 0; ///< positive where convex
    double per_length = 0;       ///< 1 / length
};

/// Of every edge, #E, in the memory of others; 0 at edges without length, and at those without two triangles that agree on
/// the outside. As the published program of MSDM2 has it, the angle is the arcsine of the sine, so that a turn of more than
/// 90 degrees counts as its supplement.
void make_bends(const TriangleMesh& mesh, const EdgeGraph& graph, std::vector<Bend>& bends);

inline std::vector<Bend> bends_of(const TriangleMesh& mesh, const EdgeGraph& graph) {
    std::vector<Bend> bends;
    make_bends(mesh, graph, bends);
    return bends;
}

} // namespace wm3d::metrics
