// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Walking over a surface from vertex to vertex.
#pragma once

#include <span>
#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::metrics {

/// An edge with the angle that the surface turns at it.
struct CurvedEdge {
    Index a = 0, b = 0; ///< a < b
    double angle = 0;   ///< between the normals of its two triangles, positive where convex; 0 at other edges
};

/// Edges of a mesh and those around each vertex.
class VertexAdjacency {
public:
    explicit VertexAdjacency(const TriangleMesh& mesh);

    std::span<const CurvedEdge> edges() const& { return edges_; }
    std::span<const CurvedEdge> edges() && = delete; // would outlive what it shows

    /// Numbers of the edges at a vertex, ascending.
    std::span<const Index> edges_at(std::size_t vertex) const {
        return {edge_at_.data() + first_[vertex], first_[vertex + 1] - first_[vertex]};
    }

    Index other_end(Index edge, Index vertex) const {
        return edges_[edge].a == vertex ? edges_[edge].b : edges_[edge].a;
    }

private:
    std::vector<CurvedEdge> edges_;
    std::vector<std::size_t> first_;
    std::vector<Index> edge_at_;
};

/// Finds the vertices in a ball that are joined to its centre by edges within the ball.
class BallWalk {
public:
    BallWalk(const TriangleMesh& mesh, const VertexAdjacency& adjacency)
        : mesh_(mesh), adjacency_(adjacency), seen_(mesh.positions.size(), 0) {}

    /// The vertices of the ball, the centre first; valid until the next call.
    std::span<const Index> gather(Index centre, double radius);

    /// Whether the last walk found the vertex.
    bool contains(Index vertex) const { return seen_[vertex] == walk_; }

private:
    const TriangleMesh& mesh_;
    const VertexAdjacency& adjacency_;
    std::vector<Index> seen_; ///< number of the walk that found the vertex last
    Index walk_ = 0;
    std::vector<Index> found_;
};

} // namespace wm3d::metrics
