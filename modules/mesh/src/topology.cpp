// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/mesh/topology.hpp>

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <span>

#include <wm3d/core/parallel.hpp>
#include <wm3d/core/split_mix.hpp>
#include <wm3d/mesh/measure.hpp>
#include <wm3d/mesh/sides.hpp>

namespace wm3d {

namespace {

/// Disjoint sets of vertices.
class Sets {
public:
    explicit Sets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), Index{0}); }

    Index root(Index v) {
        while (parent_[v] != v)
            v = parent_[v] = parent_[parent_[v]]; // halve the path on the way
        return v;
    }
    void join(Index a, Index b) { parent_[root(a)] = root(b); }

private:
    std::vector<Index> parent_;
};

/// Number of sets that hold one of the `marked` vertices.
std::size_t count_sets(Sets& sets, const std::vector<bool>& marked) {
    std::vector<bool> seen(marked.size(), false);
    std::size_t count = 0;
    for (Index v = 0; v < marked.size(); ++v)
        if (marked[v] && !seen[sets.root(v)]) {
            seen[sets.root(v)] = true;
            ++count;
        }
    return count;
}

void inspect_edges(const std::vector<Side>& sides, std::size_t vertices, Topology& topology) {
    Sets loops(vertices);
    std::vector<bool> on_boundary(vertices, false);
    for_each_edge(sides, [&](std::span<const Side> edge) {
        ++topology.edges;
        topology.non_manifold_edges += edge.size() > 2;
        topology.misoriented_edges += edge.size() == 2 && edge[0].forward == edge[1].forward;
        if (edge.size() == 1) {
            ++topology.boundary_edges;
            on_boundary[edge[0].low] = on_boundary[edge[0].high] = true;
            loops.join(edge[0].low, edge[0].high);
        }
    });
    topology.boundary_loops = count_sets(loops, on_boundary);
}

/// Lower ends of all edges that may be borders, ascending. At the others each edge has as many sides one way as the other,
/// so that hashes of the upper ends, one way less the other, come to 0: by chance alone one in 2^64 does.
std::vector<Index> lows_of_borders(const TriangleMesh& mesh) {
    std::vector<std::uint64_t> balance(mesh.positions.size(), 0);
    parallel_shares(balance.size(), mesh.triangles.size(), [&](std::size_t begin, std::size_t end) {
        for (const Triangle& t : mesh.triangles)
            for (std::size_t k = 0; k < t.size(); ++k) {
                const Index from = t[k], to = t[(k + 1) % 3], low = std::min(from, to);
                if (low >= begin && low < end && from != to) {
                    const std::uint64_t hash = split_mix_finalizer(split_mix_step + std::max(from, to));
                    balance[low] += from < to ? hash : -hash;
                }
            }
    });
    std::vector<Index> lows;
    for (Index v = 0; v < balance.size(); ++v)
        if (balance[v] != 0)
            lows.push_back(v);
    return lows;
}

} // namespace

Topology inspect_topology(const TriangleMesh& mesh) {
    Topology topology;
    const std::size_t vertices = mesh.positions.size();
    inspect_edges(sorted_sides(mesh), vertices, topology);

    Sets parts(vertices);
    std::vector<bool> used(vertices, false);
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
        const auto& [a, b, c] = mesh.triangles[f];
        parts.join(a, b);
        parts.join(b, c);
        used[a] = used[b] = used[c] = true;
        topology.degenerate_triangles += a == b || b == c || c == a || area_vector(mesh, f).isZero(0);
    }
    topology.components = count_sets(parts, used);
    const auto used_count = static_cast<std::size_t>(std::ranges::count(used, true));
    topology.isolated_vertices = vertices - used_count;
    topology.euler_characteristic =
        static_cast<long>(used_count + mesh.triangles.size()) - static_cast<long>(topology.edges);
    return topology;
}

std::vector<BorderLoop> border_loops(const TriangleMesh& mesh) {
    std::vector<Side> borders;
    const std::size_t vertices = mesh.positions.size();
    const std::vector<Index> lows = lows_of_borders(mesh);
    if (lows.empty())
        return {};
    Sets sets(vertices);
    const std::size_t at_once = std::max<std::size_t>(262'144, vertices / 4 + 1); // for memory's sake
    for (std::size_t begin = 0; begin < lows.size(); begin += at_once)
        for_each_edge(
            sorted_sides(mesh, std::span(lows).subspan(begin, std::min(at_once, lows.size() - begin))),
            [&](std::span<const Side> edge) {
                if (edge.size() != 1)
                    return;
                borders.push_back(edge[0]);
                sets.join(edge[0].low, edge[0].high);
            });

    std::vector<BorderLoop> loops;
    std::vector<Vec3> origins; // a point of each loop: near the surface, digits aren't lost
    std::vector<std::size_t> loop_of_root(mesh.positions.size(), borders.size());
    for (const Side& s : borders) {
        std::size_t& number = loop_of_root[sets.root(s.low)];
        if (number == borders.size()) {
            number = loops.size();
            loops.emplace_back();
            origins.push_back(mesh.positions[s.low]);
        }
        const Vec3 a = mesh.positions[s.low] - origins[number], b = mesh.positions[s.high] - origins[number];
        BorderLoop& loop = loops[number];
        ++loop.edges;
        const double length = (b - a).norm();
        loop.length += length;
        loop.rim += length * area_vector(mesh, s.triangle).stableNormalized();
        loop.centre += length * (a + b) / 2;                   // of length times place, from the origin
        loop.opening += (s.forward ? -0.5 : 0.5) * a.cross(b); // what closes it walks the edge the other way
    }
    for (std::size_t k = 0; k < loops.size(); ++k) {
        BorderLoop& loop = loops[k];
        const double per_length = loop.length > 0 ? 1 / loop.length : 0;
        loop.centre = origins[k] + per_length * loop.centre;
        loop.rim *= per_length;
    }
    return loops;
}

double enclosed_volume(const TriangleMesh& mesh) {
    // Tetrahedra over the triangles, from a corner of the box: near the surface, digits aren't lost to a far
    // origin.
    const Vec3 origin = surface_box(mesh).min;
    return parallel_sum_of(mesh.triangles.size(), 4096, [&](std::size_t f) {
        const auto& [a, b, c] = mesh.triangles[f];
        const Vec3 u = mesh.positions[a] - origin, v = mesh.positions[b] - origin,
                   w = mesh.positions[c] - origin;
        return u.dot(v.cross(w)) / 6;
    });
}

} // namespace wm3d
