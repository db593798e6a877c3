// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/mesh/neighbours.hpp>

#include <algorithm>

namespace wm3d {

namespace {

std::vector<char> border_flags(std::size_t vertices, const std::vector<Edge>& edges) {
    std::vector<char> border(vertices, 0);
    for (const Edge& e : edges)
        if (e.faces == 1)
            border[e.a] = border[e.b] = 1;
    return border;
}

} // namespace

std::vector<Edge> edges_of(const TriangleMesh& mesh) {
    std::vector<std::uint64_t> keys;
    keys.reserve(3 * mesh.triangles.size());
    for (const Triangle& t : mesh.triangles)
        for (int k = 0; k < 3; ++k) {
            const auto [low, high] = std::minmax(t[k], t[(k + 1) % 3]);
            keys.push_back(std::uint64_t{low} << 32 | high);
        }
    std::sort(keys.begin(), keys.end());
    std::vector<Edge> edges;
    edges.reserve(keys.size() / 2);
    for (std::size_t i = 0; i < keys.size(); ++i) {
        if (i == 0 || keys[i] != keys[i - 1])
            edges.push_back({static_cast<Index>(keys[i] >> 32), static_cast<Index>(keys[i]), 0});
        ++edges.back().faces;
    }
    return edges;
}

std::vector<char> border_vertices(const TriangleMesh& mesh) {
    return border_flags(mesh.positions.size(), edges_of(mesh));
}

Neighbours::Neighbours(const TriangleMesh& mesh) : first_(mesh.positions.size() + 1, 0) {
    const std::vector<Edge> edges = edges_of(mesh);
    border_ = border_flags(mesh.positions.size(), edges);
    for (const Edge& e : edges) {
        ++first_[e.a + 1];
        ++first_[e.b + 1];
    }
    for (std::size_t v = 0; v + 1 < first_.size(); ++v)
        first_[v + 1] += first_[v];
    neighbour_.resize(first_.back());
    // Edges come sorted by (a, b): the smaller neighbours of every vertex are filled in before the larger.
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (const Edge& e : edges)
        neighbour_[next[e.b]++] = e.a;
    for (const Edge& e : edges)
        neighbour_[next[e.a]++] = e.b;
}

} // namespace wm3d
