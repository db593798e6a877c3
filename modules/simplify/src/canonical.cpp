// SPDX-License-Identifier: GPL-3.0-or-later
#include "canonical.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <tuple>

#include <fmt/format.h>
#include <wm3d/core/error.hpp>
#include <wm3d/core/parallel.hpp>
#include <wm3d/mesh/curve_order.hpp>
#include <wm3d/mesh/measure.hpp>

namespace wm3d::simplify {

namespace {

constexpr std::size_t canonical_block = 16384;
constexpr std::uint64_t radix = 1u << morton_bits; // three passes sort the whole code

/// A vertex and its place on the curve.
struct Keyed {
    std::uint64_t code;
    Index vertex;
};

bool degenerate(const Triangle& t) {
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

void check(const TriangleMesh& mesh) {
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
        for (Index v : mesh.triangles[f]) {
            if (v >= mesh.positions.size())
                throw GeometryError(fmt::format("triangle {} names vertex {}, but the mesh has {} vertices: "
                                                "the list of triangles or of vertices is damaged, export the "
                                                "model again",
                                                f, v, mesh.positions.size()));
            if (!mesh.positions[v].allFinite())
                throw GeometryError(
                    fmt::format("vertex {} has a coordinate that is not a finite number: repair "
                                "or remove that vertex",
                                v));
        }
}

void radix_sort(std::vector<Keyed>& keys) {
    std::vector<Keyed> sorted(keys.size());
    for (int pass = 0; pass < 3; ++pass) {
        const int shift = pass * morton_bits;
        std::array<std::size_t, radix + 1> start{};
        for (const Keyed& k : keys)
            ++start[((k.code >> shift) & (radix - 1)) + 1];
        for (std::size_t d = 0; d < radix; ++d)
            start[d + 1] += start[d];
        for (const Keyed& k : keys)
            sorted[start[(k.code >> shift) & (radix - 1)]++] = k;
        keys.swap(sorted);
    }
}

/// Vertices of one grid cell come in the order of their coordinates.
void order_cells(std::vector<Keyed>& keys, const std::vector<Vec3>& positions) {
    const auto before = [&](const Keyed& a, const Keyed& b) {
        const Vec3 &p = positions[a.vertex], &q = positions[b.vertex];
        return std::tie(p[0], p[1], p[2], a.vertex) < std::tie(q[0], q[1], q[2], b.vertex);
    };
    for (auto begin = keys.begin(); begin != keys.end();) {
        const auto end =
            std::find_if(begin + 1, keys.end(), [&](const Keyed& k) { return k.code != begin->code; });
        if (end - begin > 1)
            std::sort(begin, end, before);
        begin = end;
    }
}

/// Fills positions and input_vertex; returns the number of each input vertex on the curve.
std::vector<Index> order_vertices(const TriangleMesh& mesh, Canonical& out) {
    std::vector<Index> number(mesh.positions.size(), no_index);
    for (const Triangle& t : mesh.triangles)
        if (!degenerate(t))
            for (Index v : t)
                number[v] = 0;

    const Box box = surface_box(mesh);
    const Vec3 centre = 0.5 * box.min + 0.5 * box.max;
    const double side = (box.max - box.min).maxCoeff();
    out.scale = side > 0 && std::isfinite(side) ? side : 1;

    std::vector<Keyed> keys;
    keys.reserve(mesh.positions.size());
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        if (number[v] != no_index)
            keys.push_back({0, static_cast<Index>(v)});
    parallel_blocks(keys.size(), canonical_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            keys[i].code = morton_code((mesh.positions[keys[i].vertex] - centre) / out.scale);
    });
    radix_sort(keys);
    order_cells(keys, mesh.positions);

    out.positions.resize(keys.size());
    out.input_vertex.resize(keys.size());
    for (std::size_t i = 0; i < keys.size(); ++i) {
        number[keys[i].vertex] = static_cast<Index>(i);
        out.input_vertex[i] = keys[i].vertex;
        out.positions[i] = (mesh.positions[keys[i].vertex] - centre) / out.scale;
    }
    return number;
}

/// Orders triangles that share their first corner; repeats come to stand side by side.
auto rank(const Triangle& t) {
    return std::tuple(std::min(t[1], t[2]), std::max(t[1], t[2]), t[1]);
}

bool same_corners(const Triangle& a, const Triangle& b) {
    return a[0] == b[0] && std::minmax(a[1], a[2]) == std::minmax(b[1], b[2]);
}

/// Triangles of the new numbers, sorted by their corners, each set of corners once.
void order_triangles(const TriangleMesh& mesh, const std::vector<Index>& number, Canonical& out) {
    std::vector<Index> start(out.positions.size() + 1, 0);
    const auto renumbered = [&](const Triangle& t) {
        Triangle r{number[t[0]], number[t[1]], number[t[2]]};
        std::rotate(r.begin(), std::min_element(r.begin(), r.end()), r.end());
        return r;
    };
    for (const Triangle& t : mesh.triangles)
        if (!degenerate(t))
            ++start[renumbered(t)[0] + 1];
    for (std::size_t v = 1; v < start.size(); ++v)
        start[v] += start[v - 1];

    std::vector<Triangle>& sorted = out.triangles;
    sorted.resize(start.back());
    for (const Triangle& t : mesh.triangles)
        if (!degenerate(t)) {
            const Triangle r = renumbered(t);
            sorted[start[r[0]]++] = r;
        }
    // By now `start` tells where the triangles of each first corner end.
    parallel_blocks(out.positions.size(), canonical_block, [&](std::size_t first, std::size_t last) {
        for (std::size_t v = first; v < last; ++v)
            std::sort(sorted.begin() + (v == 0 ? 0 : start[v - 1]), sorted.begin() + start[v],
                      [](const Triangle& a, const Triangle& b) { return rank(a) < rank(b); });
    });
    sorted.erase(std::unique(sorted.begin(), sorted.end(), same_corners), sorted.end());
}

} // namespace

Canonical canonical_order(const TriangleMesh& mesh) {
    check(mesh);
    Canonical out;
    const std::vector<Index> number = order_vertices(mesh, out);
    order_triangles(mesh, number, out);
    return out;
}

} // namespace wm3d::simplify
