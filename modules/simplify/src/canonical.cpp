// SPDX-License-Identifier: GPL-3.0-or-later
#include "canonical.hpp"

#include <algorithm>
#include <array>
#include <atomic>
#include <cmath>
#include <tuple>
#include <utility>

#include <fmt/format.h>
#include <wm3d/core/error.hpp>
#include <wm3d/core/filed.hpp>
#include <wm3d/core/parallel.hpp>
#include <wm3d/mesh/curve_order.hpp>
#include <wm3d/mesh/measure.hpp>

namespace wm3d::simplify {

namespace {

constexpr std::size_t canonical_block = 16384;
constexpr std::uint64_t radix = 1u << morton_bits; // three passes sort the whole code
constexpr std::size_t sorted_block = 1u << 19;     // of keys, with counts of its own

/// A vertex and its place on the curve.
struct Keyed {
    std::uint64_t code;
    Index vertex;
};

bool degenerate(const Triangle& t) {
    return t[0] == t[1] || t[1] == t[2] || t[2] == t[0];
}

/// Whether body(i) holds for every i of [0, count).
template<typename Test>
bool holds_for_all(std::size_t count, Test&& test) {
    std::atomic<bool> holds = true;
    parallel_blocks(count, canonical_block, [&](std::size_t begin, std::size_t end) {
        bool all = true;
        for (std::size_t i = begin; i < end; ++i)
            all = all && test(i);
        if (!all)
            holds = false;
    });
    return holds;
}

/// Vertices that no triangle names may lie anywhere, so what looks unsound at first is looked at again.
void check(const TriangleMesh& mesh) {
    const std::size_t vertices = mesh.positions.size();
    if (holds_for_all(mesh.triangles.size(),
                      [&](std::size_t f) { return std::ranges::max(mesh.triangles[f]) < vertices; }) &&
        holds_for_all(vertices, [&](std::size_t v) { return mesh.positions[v].allFinite(); }))
        return;
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
    using Places = std::array<std::size_t, radix>; // of the digits' next keys
    std::vector<Keyed> sorted(keys.size());
    std::vector<Places> places((keys.size() + sorted_block - 1) / sorted_block);
    for (int pass = 0; pass < 3; ++pass) {
        const auto digit = [&](const Keyed& k) { return k.code >> pass * morton_bits & (radix - 1); };
        parallel_blocks(keys.size(), sorted_block, [&](std::size_t begin, std::size_t end) {
            Places& counts = places[begin / sorted_block];
            counts.fill(0);
            for (std::size_t i = begin; i < end; ++i)
                ++counts[digit(keys[i])];
        });
        std::size_t place = 0;
        for (std::size_t d = 0; d < radix; ++d)
            for (Places& of_block : places)
                place += std::exchange(of_block[d], place);
        parallel_blocks(keys.size(), sorted_block, [&](std::size_t begin, std::size_t end) {
            Places& next = places[begin / sorted_block];
            for (std::size_t i = begin; i < end; ++i)
                sorted[next[digit(keys[i])]++] = keys[i];
        });
        keys.swap(sorted);
    }
}

/// Vertices of one grid cell come in the order of their coordinates.
void order_cells(std::vector<Keyed>& keys, const std::vector<Vec3>& positions) {
    const auto before = [&](const Keyed& a, const Keyed& b) {
        const Vec3 &p = positions[a.vertex], &q = positions[b.vertex];
        return std::tie(p[0], p[1], p[2], a.vertex) < std::tie(q[0], q[1], q[2], b.vertex);
    };
    // A cell belongs to the block in which it begins.
    const std::size_t blocks = (keys.size() + canonical_block - 1) / canonical_block;
    std::vector<std::size_t> first(blocks + 1, keys.size());
    for (std::size_t b = blocks; b-- > 0;) {
        std::size_t begin = b * canonical_block;
        const std::size_t end = std::min(begin + canonical_block, keys.size());
        while (begin > 0 && begin < end && keys[begin].code == keys[begin - 1].code)
            ++begin;
        first[b] = begin < end ? begin : first[b + 1];
    }
    parallel_blocks(blocks, 1, [&](std::size_t b, std::size_t) {
        const auto last = keys.begin() + static_cast<std::ptrdiff_t>(first[b + 1]);
        for (auto begin = keys.begin() + static_cast<std::ptrdiff_t>(first[b]); begin < last;) {
            const auto end =
                std::find_if(begin + 1, last, [&](const Keyed& k) { return k.code != begin->code; });
            if (end - begin > 1)
                std::sort(begin, end, before);
            begin = end;
        }
    });
}

/// Vertices that a triangle which isn't degenerate uses, with their places on the curve, in the order of the input.
std::vector<Keyed> keys_of(const TriangleMesh& mesh, const Vec3& centre, double scale) {
    std::vector<char> used(mesh.positions.size(), 0);
    parallel_shares(used.size(), mesh.triangles.size(), [&](std::size_t begin, std::size_t end) {
        for (const Triangle& t : mesh.triangles)
            if (!degenerate(t))
                for (const Index v : t)
                    if (v >= begin && v < end)
                        used[v] = 1;
    });
    std::vector<Keyed> keys;
    keys.reserve(used.size());
    for (std::size_t v = 0; v < used.size(); ++v)
        if (used[v])
            keys.push_back({0, static_cast<Index>(v)});
    parallel_blocks(keys.size(), canonical_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            keys[i].code = morton_code((mesh.positions[keys[i].vertex] - centre) / scale);
    });
    return keys;
}

/// Fills positions and input_vertex; returns the number of each input vertex on the curve.
std::vector<Index> order_vertices(const TriangleMesh& mesh, Canonical& out) {
    const Box box = surface_box(mesh);
    const Vec3 centre = 0.5 * box.min + 0.5 * box.max;
    const double side = (box.max - box.min).maxCoeff();
    out.scale = side > 0 && std::isfinite(side) ? side : 1;

    std::vector<Keyed> keys = keys_of(mesh, centre, out.scale);
    radix_sort(keys);
    order_cells(keys, mesh.positions);

    std::vector<Index> number(mesh.positions.size(), no_index);
    out.positions.resize(keys.size());
    out.input_vertex.resize(keys.size());
    parallel_blocks(keys.size(), canonical_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            number[keys[i].vertex] = static_cast<Index>(i);
            out.input_vertex[i] = keys[i].vertex;
            out.positions[i] = (mesh.positions[keys[i].vertex] - centre) / out.scale;
        }
    });
    return number;
}

/// Orders triangles that share their first corner; repeats come to stand side by side.
bool comes_before(const Triangle& a, const Triangle& b) {
    const auto others = [](const Triangle& t) {
        return std::uint64_t{std::min(t[1], t[2])} << 32 | std::max(t[1], t[2]);
    };
    const std::uint64_t of_a = others(a), of_b = others(b);
    return of_a != of_b ? of_a < of_b : a[1] < b[1];
}

bool same_corners(const Triangle& a, const Triangle& b) {
    return a[0] == b[0] && std::minmax(a[1], a[2]) == std::minmax(b[1], b[2]);
}

/// A triangle of the new numbers, from the least on.
Triangle renumbered(const Triangle& t, const std::vector<Index>& number) {
    Triangle r{number[t[0]], number[t[1]], number[t[2]]};
    std::rotate(r.begin(), std::min_element(r.begin(), r.end()), r.end());
    return r;
}

/// The least new number of each triangle, #F; no_index of degenerate ones.
std::vector<Index> first_corners(const TriangleMesh& mesh, const std::vector<Index>& number) {
    std::vector<Index> first(mesh.triangles.size());
    parallel_blocks(first.size(), canonical_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
            const Triangle& t = mesh.triangles[f];
            first[f] = degenerate(t) ? no_index : std::min({number[t[0]], number[t[1]], number[t[2]]});
        }
    });
    return first;
}

/// Triangles of the new numbers, sorted by their corners, each set of corners once.
void order_triangles(const TriangleMesh& mesh, const std::vector<Index>& number, Canonical& out) {
    const std::vector<Index> first = first_corners(mesh, number);
    Filed<Triangle> by_first = filed<Triangle>(out.positions.size(), first.size(), [&](auto&& file) {
        for (std::size_t f = 0; f < first.size(); ++f)
            file(first[f], [&] { return renumbered(mesh.triangles[f], number); });
    });
    parallel_blocks(out.positions.size(), canonical_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v)
            std::ranges::sort(by_first.under(v), comes_before);
    });
    std::vector<Triangle>& sorted = out.triangles;
    sorted = std::move(by_first.values);
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
