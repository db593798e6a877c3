// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Measures and hostile meshes for the tests.
#pragma once

#include <wm3d/mesh.hpp>

namespace wm3d::attack::test {

/// No edge has more than two triangles, and neighbours agree in orientation.
inline bool is_manifold(const TriangleMesh& mesh) {
    const Topology topology = inspect_topology(mesh);
    return topology.non_manifold_edges + topology.misoriented_edges == 0;
}

inline double mean_edge(const TriangleMesh& mesh) {
    double sum = 0;
    for (const Triangle& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k)
            sum += (mesh.positions[t[k]] - mesh.positions[t[(k + 1) % 3]]).norm();
    return sum / static_cast<double>(3 * mesh.triangles.size());
}

/// Sum of squared edge lengths over half-edges: the umbrella's Dirichlet energy.
inline double dirichlet_energy(const TriangleMesh& mesh) {
    double sum = 0;
    for (const Triangle& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k)
            sum += (mesh.positions[t[k]] - mesh.positions[t[(k + 1) % 3]]).squaredNorm();
    return sum;
}

/// Both meshes side by side, without shared vertices.
inline TriangleMesh joined(TriangleMesh a, const TriangleMesh& b, const Vec3& move) {
    const auto base = static_cast<Index>(a.positions.size());
    for (const Vec3& p : b.positions)
        a.positions.push_back(p + move);
    for (const Triangle& t : b.triangles)
        a.triangles.push_back({t[0] + base, t[1] + base, t[2] + base});
    return a;
}

/// A fan of three sheets around one edge, a bow tie at one vertex, a triangle twice, a triangle turned over,
/// a flat triangle and an isolated vertex.
inline TriangleMesh hostile() {
    return {{{0, 0, 0},
             {1, 0, 0},
             {0, 1, 0},
             {0, -1, 0},
             {0, 0, 1},
             {3, 0, 0},
             {3, 1, 0},
             {4, 0, 0},
             {4, 1, 0.5},
             {9, 9, 9}},
            {{0, 1, 2}, {1, 0, 3}, {0, 1, 4}, {1, 5, 6}, {5, 6, 7}, {7, 6, 8}, {7, 6, 8}, {0, 1, 5}}};
}

inline bool same(const TriangleMesh& a, const TriangleMesh& b) {
    return a.positions == b.positions && a.triangles == b.triangles;
}

} // namespace wm3d::attack::test
