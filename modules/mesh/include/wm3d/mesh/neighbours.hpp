// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Edges and vertex neighbours of an indexed mesh, whatever its topology.
#pragma once

#include <span>
#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d {

struct Edge {
    Index a = 0, b = 0; ///< a < b
    Index faces = 0;    ///< number of triangles at the edge; 1 at a border
};

/// Every edge once, sorted by its vertices.
std::vector<Edge> edges_of(const TriangleMesh& mesh);

/// Whether each vertex lies on a border, #V: an end of an edge that has one triangle.
std::vector<char> border_vertices(const TriangleMesh& mesh);

/// Vertices joined to each vertex by an edge, in ascending order, in one array.
class Neighbours {
public:
    explicit Neighbours(const TriangleMesh& mesh);

    std::span<const Index> of(std::size_t vertex) const {
        return {neighbour_.data() + first_[vertex], first_[vertex + 1] - first_[vertex]};
    }
    bool on_border(std::size_t vertex) const { return border_[vertex] != 0; }

private:
    std::vector<std::size_t> first_;
    std::vector<Index> neighbour_;
    std::vector<char> border_;
};

} // namespace wm3d
