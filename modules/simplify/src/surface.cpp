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

#include "corners.hpp"
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

    void clear() { size = 0; }

    void add(Index f, Index t, Index c) {
        if (size % lane == 0)
            std::fill_n(from.begin() + size, lane, no_index);
        from[size] = f, to[size] = t, corner[size] = c;
        ++size;
    }

    /// A bit for each of the wedges that begin at `vertex`. Without branches: their order is as good as
    /// random.
    std::uint64_t beginning_at(Index vertex) const {
        std::uint64_t found = 0;
        for (std::size_t base = 0; base < size; base += lane)
            for (std::size_t i = 0; i < lane; ++i)
                found |= std::uint64_t{from[base + i] == vertex} << (base + i);
        return found;
    }

    /// Finds the order in which each wedge begins where the one before ends. False if they are not one fan.
    bool chain(std::array<unsigned char, many>& order) const {
        std::array<std::uint64_t, many> follower;
        std::uint64_t following = 0; // wedges that begin where another ends
        bool single = true;
        for (std::size_t i = 0; i < size; ++i) {
            follower[i] = beginning_at(to[i]);
            single = single && std::popcount(follower[i]) <= 1 && (following & follower[i]) == 0;
            following |= follower[i];
        }
        const std::uint64_t first = ~following & (~std::uint64_t{0} >> (many - size)); // of an open fan
        if (!single || std::popcount(first) > 1 || (first == 0 && size < 3))
            return false;
        auto at = static_cast<std::size_t>(first == 0 ? 0 : std::countr_zero(first));
        std::uint64_t met = 0;
        for (std::size_t i = 0; i < size; ++i) {
            order[i] = static_cast<unsigned char>(at);
            met |= std::uint64_t{1} << at;
            if (follower[at] != 0)
                at = static_cast<std::size_t>(std::countr_zero(follower[at]));
        }
        return std::popcount(met) == static_cast<int>(size);
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
    std::vector<Index> sizes(mesh.leaving.size(), 0);
    for (Index v = 0; v < sizes.size(); ++v)
        walk(mesh, v, [&](Index, Index) { ++sizes[v]; });
    Rings rings(sizes);
    for (Index v = 0; v < sizes.size(); ++v) {
        Spoke* spoke = rings.ring(v).data();
        walk(mesh, v, [&](Index neighbour, Index corner) { *spoke++ = {neighbour, corner}; });
    }
    return rings;
}

} // namespace

std::optional<Rings> rings_of_manifold(const std::vector<Triangle>& triangles, std::size_t vertices,
                                       std::size_t wanted) {
    const Corners by = corners_by_vertex(triangles, vertices);
    std::vector<Index> sizes(vertices, 0);
    std::vector<Triangle> ordered(by.corners.size());
    std::atomic<bool> manifold = true;
    parallel_blocks(wanted, vertex_block, [&](std::size_t begin, std::size_t end) {
        Wedges wedges;
        std::array<unsigned char, many> order;
        for (std::size_t v = begin; v < end && manifold; ++v) {
            wedges.clear();
            if (by.start[v + 1] - by.start[v] > many) {
                manifold = false;
                return;
            }
            for (Index i = by.start[v]; i < by.start[v + 1]; ++i) {
                const Index h = by.corners[i];
                const Triangle& t = triangles[h / 3];
                wedges.add(t[next(h) % 3], t[previous(h) % 3], h);
            }
            if (!wedges.chain(order)) {
                manifold = false;
                return;
            }
            const bool closed = wedges.to[order[wedges.size - 1]] == wedges.from[order[0]];
            sizes[v] = static_cast<Index>(wedges.size) + (closed ? 0 : 1);
            for (std::size_t i = 0; i < wedges.size; ++i)
                ordered[by.start[v] + i] = {wedges.from[order[i]], wedges.to[order[i]],
                                            wedges.corner[order[i]]};
        }
    });
    if (!manifold)
        return std::nullopt;
    Rings rings(sizes);
    parallel_blocks(wanted, vertex_block, [&](std::size_t begin, std::size_t end) {
        for (auto v = static_cast<Index>(begin); v < end; ++v) {
            Spoke* spoke = rings.ring(v).data();
            for (Index i = by.start[v]; i < by.start[v + 1]; ++i)
                *spoke++ = {ordered[i][0], ordered[i][2]};
            if (sizes[v] > by.start[v + 1] - by.start[v])
                *spoke = {ordered[by.start[v + 1] - 1][1], no_index};
        }
    });
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
