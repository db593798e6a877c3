// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  What a test asks of a surface.
#pragma once

#include <map>
#include <numeric>
#include <utility>
#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::shapes {

struct Topology {
    long euler = 0;
    std::size_t boundary_edges = 0;
    bool oriented = true;
};

/// Euler characteristic, boundary edges, and whether each edge is walked at most once in each direction.
inline Topology topology(const TriangleMesh& mesh) {
    std::map<std::pair<Index, Index>, int> half_edges;
    for (const Triangle& t : mesh.triangles)
        for (int k = 0; k < 3; ++k)
            ++half_edges[{t[k], t[(k + 1) % 3]}];
    Topology result;
    std::size_t edges = 0;
    for (const auto& [edge, count] : half_edges) {
        result.oriented = result.oriented && count == 1;
        const bool twin = half_edges.contains({edge.second, edge.first});
        result.boundary_edges += !twin;
        edges += !twin || edge.first < edge.second;
    }
    result.euler =
        static_cast<long>(mesh.positions.size() + mesh.triangles.size()) - static_cast<long>(edges);
    return result;
}

/// Volume that a closed surface encloses; positive if its normals point outwards.
inline double volume(const TriangleMesh& mesh) {
    double sum = 0;
    for (const Triangle& t : mesh.triangles)
        sum += mesh.positions[t[0]].dot(mesh.positions[t[1]].cross(mesh.positions[t[2]])) / 6;
    return sum;
}

/// Number of connected parts; an isolated vertex counts as one.
inline std::size_t components(const TriangleMesh& mesh) {
    std::vector<Index> parent(mesh.positions.size());
    std::iota(parent.begin(), parent.end(), Index{0});
    const auto root = [&](Index v) {
        while (parent[v] != v)
            v = parent[v] = parent[parent[v]];
        return v;
    };
    std::size_t count = mesh.positions.size();
    for (const Triangle& t : mesh.triangles)
        for (const Index corner : {t[1], t[2]})
            if (const Index a = root(t[0]), b = root(corner); a != b) {
                parent[a] = b;
                --count;
            }
    return count;
}

} // namespace wm3d::shapes
