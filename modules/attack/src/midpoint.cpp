// SPDX-License-Identifier: GPL-3.0-or-later
#include "midpoint.hpp"

#include <algorithm>

#include <wm3d/mesh/neighbours.hpp>

namespace wm3d::attack {

TriangleMesh subdivide_midpoint(const TriangleMesh& mesh) {
    const std::vector<Edge> edges = edges_of(mesh);
    TriangleMesh fine;
    fine.positions = mesh.positions;
    fine.positions.reserve(mesh.positions.size() + edges.size());
    for (const Edge& e : edges)
        fine.positions.push_back(0.5 * (mesh.positions[e.a] + mesh.positions[e.b]));

    const auto middle = [&](Index a, Index b) {
        const auto [low, high] = std::minmax(a, b);
        const auto at =
            std::partition_point(edges.begin(), edges.end(), [low = low, high = high](const Edge& e) {
                return e.a < low || (e.a == low && e.b < high);
            });
        return static_cast<Index>(mesh.positions.size() + static_cast<std::size_t>(at - edges.begin()));
    };
    fine.triangles.reserve(4 * mesh.triangles.size());
    for (const auto& [a, b, c] : mesh.triangles) {
        const Index ab = middle(a, b), bc = middle(b, c), ca = middle(c, a);
        fine.triangles.insert(fine.triangles.end(), {{a, ab, ca}, {ab, b, bc}, {ca, bc, c}, {ab, bc, ca}});
    }
    return fine;
}

} // namespace wm3d::attack
