// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/mesh/neighbours.hpp>

#include <algorithm>
#include <numeric>

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
    // Filed under their lower ends: what is left to sort are the few at one vertex.
    std::vector<std::size_t> end(mesh.positions.size() + 1, 0);
    const auto for_each_side = [&](auto&& visit) {
        for (const Triangle& t : mesh.triangles)
            for (std::size_t k = 0; k < 3; ++k)
                visit(std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3]));
    };
    for_each_side([&](Index low, Index) { ++end[low + 1]; });
    std::partial_sum(end.begin(), end.end(), end.begin());
    std::vector<Index> highs(end.back());
    for_each_side([&](Index low, Index high) { highs[end[low]++] = high; });

    std::vector<Edge> edges;
    edges.reserve(highs.size() / 2);
    auto begin = highs.begin();
    for (Index low = 0; low < mesh.positions.size(); ++low) {
        const auto last = highs.begin() + static_cast<std::ptrdiff_t>(end[low]);
        std::sort(begin, last);
        for (auto high = begin; high != last; ++high) {
            if (high == begin || *high != high[-1])
                edges.push_back({low, *high, 0});
            ++edges.back().faces;
        }
        begin = last;
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
