// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <bit>
#include <cstdint>
#include <numeric>
#include <optional>
#include <utility>

#include <wm3d/core/parallel.hpp>

#include "half_edges.hpp"

namespace wm3d::simplify {

namespace {

constexpr std::size_t vertex_block = 4096;
constexpr std::size_t many = 64; ///< triangles at a vertex that are still chained by comparing all with all
constexpr std::size_t lane = 8;

/// The wedges of a vertex: in its triangle i the neighbours from[i] and to[i], counter-clockwise, and its
/// corner.
struct Wedges {
    std::array<Index, many> from, to, corner;
    std::size_t size = 0;

    /// From spokes that begin the wedges, in any order.
    void gather(Ring spokes, const std::vector<Triangle>& triangles) {
        size = spokes.size();
        for (std::size_t i = 0; i < size; ++i) {
            from[i] = spokes[i].vertex;
            corner[i] = spokes[i].corner;
            to[i] = triangles[corner[i] / 3][previous(corner[i]) % 3];
        }
        std::fill(to.begin() + size, to.begin() + (size + lane - 1) / lane * lane, no_index);
    }

    /// Finds the order in which each wedge begins where the one before ends. False if they are not one fan.
    bool chain(std::array<unsigned char, many>& order) const {
        constexpr Index found = many; // plus the number of the follower; twice that and more: several follow
        std::array<Index, many> follower;
        std::uint64_t followers = 0;
        for (std::size_t base = 0; base < size; base += lane) {
            std::array<Index, lane> sum{};
            for (std::size_t k = 0; k < size; ++k)
                for (std::size_t i = 0; i < lane; ++i) // without branches: their order is as good as random
                    sum[i] += from[k] == to[base + i] ? found + static_cast<Index>(k) : 0;
            std::ranges::copy(sum, follower.begin() + base);
        }
        bool single = true;
        for (std::size_t i = 0; i < size; ++i) {
            single = single && follower[i] < 2 * found;
            followers |= std::uint64_t{follower[i] >= found} << follower[i] % found;
        }
        const auto first = static_cast<std::size_t>(std::countr_one(followers)); // of an open fan
        const bool closed = first >= size;
        if (!single || size == 0 || (closed && size < 3))
            return false;
        std::size_t at = closed ? 0 : first;
        for (std::size_t i = 0; i + 1 < size; ++i) {
            order[i] = static_cast<unsigned char>(at);
            if (follower[at] == 0)
                return false;
            at = follower[at] % found;
            if (at == order[0])
                return false;
        }
        order[size - 1] = static_cast<unsigned char>(at);
        return closed ? follower[at] == found + order[0] : follower[at] == 0;
    }
};

/// Calls visit(neighbour, corner) for each spoke of v.
template<typename Visit>
void walk(const HalfEdges& mesh, Index v, Visit&& visit) {
    const Index start = mesh.leaving[v];
    Index h = start, last = h;
    do {
        visit(mesh.target(h), h);
        last = h;
        h = mesh.turn(h);
    } while (h != start && h != no_index);
    if (h == no_index)
        visit(mesh.edges[previous(last)].origin, no_index);
}

Rings rings_of(const HalfEdges& mesh) {
    Rings rings(mesh.leaving.size());
    for (Index v = 0; v < rings.size(); ++v)
        walk(mesh, v, [&](Index neighbour, Index corner) { rings.append(v, {neighbour, corner}); });
    return rings;
}

/// Rings of the first vertices, one spoke for each of their triangles, in the order of the triangles.
Rings unordered_rings(const std::vector<Triangle>& triangles, std::size_t vertices, std::size_t wanted) {
    Rings rings(vertices);
    for (std::size_t f = 0; f < triangles.size(); ++f)
        for (Index k = 0; k < 3; ++k)
            if (const Index v = triangles[f][k]; v < wanted)
                rings.append(v, {triangles[f][next(k)], static_cast<Index>(3 * f) + k});
    return rings;
}

/// The last spoke of an open ring.
struct End {
    Index vertex, neighbour;
};

} // namespace

std::optional<Rings> rings_of_manifold(const std::vector<Triangle>& triangles, std::size_t vertices,
                                       std::size_t wanted) {
    Rings rings = unordered_rings(triangles, vertices, wanted);
    std::vector<std::vector<End>> ends((wanted + vertex_block - 1) / vertex_block);
    std::atomic<bool> manifold = true;
    parallel_blocks(wanted, vertex_block, [&](std::size_t begin, std::size_t end) {
        Wedges wedges;
        std::array<unsigned char, many> order;
        for (auto v = static_cast<Index>(begin); v < end && manifold; ++v) {
            const std::span<Spoke> ring = rings.ring(v);
            if (ring.size() > many) {
                manifold = false;
                return;
            }
            wedges.gather(ring, triangles);
            if (!wedges.chain(order)) {
                manifold = false;
                return;
            }
            for (std::size_t i = 0; i < ring.size(); ++i)
                ring[i] = {wedges.from[order[i]], wedges.corner[order[i]]};
            if (const Index last = wedges.to[order[ring.size() - 1]]; last != ring.front().vertex)
                ends[begin / vertex_block].push_back({v, last});
        }
    });
    if (!manifold)
        return std::nullopt;
    for (const std::vector<End>& of_block : ends)
        for (const End& end : of_block)
            rings.append(end.vertex, {end.neighbour, no_index});
    return rings;
}

Surface build_surface(std::vector<Triangle> triangles, const std::vector<Vec3>& positions) {
    if (std::optional<Rings> rings = rings_of_manifold(triangles, positions.size(), positions.size())) {
        std::vector<Index> source(positions.size());
        std::iota(source.begin(), source.end(), Index{0});
        return {std::move(*rings), std::move(source), std::vector<bool>(positions.size(), false)};
    }
    HalfEdges half_edges = build_half_edges(std::move(triangles), positions);
    return {rings_of(half_edges), std::move(half_edges.source), std::move(half_edges.locked)};
}

} // namespace wm3d::simplify
