// SPDX-License-Identifier: GPL-3.0-or-later
#include "edge_graph.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <wm3d/core/parallel.hpp>
#include <wm3d/mesh/measure.hpp>

namespace wm3d::metrics {

namespace {

/// A side of a triangle, filed under its lower end.
struct Side {
    Index high;
    Index triangle;
    bool forward; ///< the triangle walks from the lower end to the higher one
};

/// Turns counts, #groups + 1 with the first 0, into where each group begins.
void accumulate(std::vector<std::size_t>& counts) {
    for (std::size_t i = 0; i + 1 < counts.size(); ++i)
        counts[i + 1] += counts[i];
}

/// All sides by their lower ends, those of one edge together.
struct Sides {
    std::vector<std::size_t> first; ///< #V + 1
    std::vector<Side> sides;        ///< #F by 3

    explicit Sides(const TriangleMesh& mesh)
        : first(mesh.positions.size() + 1, 0), sides(3 * mesh.triangles.size()) {
        const auto for_each = [&](auto&& visit) {
            for (Index f = 0; f < mesh.triangles.size(); ++f)
                for (std::size_t k = 0; k < 3; ++k)
                    visit(f, mesh.triangles[f][k], mesh.triangles[f][(k + 1) % 3]);
        };
        for_each([&](Index, Index from, Index to) { ++first[std::min(from, to) + 1]; });
        accumulate(first);
        std::vector<std::size_t> next(first.begin(), first.end() - 1);
        for_each([&](Index f, Index from, Index to) {
            sides[next[std::min(from, to)]++] = {std::max(from, to), f, from < to};
        });
        parallel_blocks(mesh.positions.size(), 4096, [&](std::size_t begin, std::size_t end) {
            for (std::size_t v = begin; v < end; ++v)
                std::sort(sides.begin() + static_cast<std::ptrdiff_t>(first[v]),
                          sides.begin() + static_cast<std::ptrdiff_t>(first[v + 1]),
                          [](const Side& s, const Side& t) {
                              return std::tie(s.high, s.triangle) < std::tie(t.high, t.triangle);
                          });
        });
    }
};

} // namespace

EdgeGraph::EdgeGraph(const TriangleMesh& mesh)
    : first_way_(mesh.positions.size() + 1, 0), first_triangle_(mesh.positions.size() + 1, 0) {
    const Sides by_low(mesh);
    const std::vector<Side>& sides = by_low.sides;
    edges_.reserve(sides.size() / 2);
    for (Index low = 0; low < mesh.positions.size(); ++low)
        for (std::size_t i = by_low.first[low], end = i; i < by_low.first[low + 1]; i = end) {
            while (end < by_low.first[low + 1] && sides[end].high == sides[i].high)
                ++end;
            Edge edge{low, sides[i].high};
            if (end - i == 2 && sides[i].forward != sides[i + 1].forward) {
                edge.left = sides[sides[i].forward ? i : i + 1].triangle;
                edge.right = sides[sides[i].forward ? i + 1 : i].triangle;
            }
            edges_.push_back(edge);
        }

    for (const Edge& e : edges_) {
        ++first_way_[e.a + 1];
        ++first_way_[e.b + 1];
    }
    accumulate(first_way_);
    ways_.resize(first_way_.back());
    std::vector<std::size_t> next(first_way_.begin(), first_way_.end() - 1);
    for (Index e = 0; e < edges_.size(); ++e) {
        ways_[next[edges_[e].a]++] = {edges_[e].b, e};
        ways_[next[edges_[e].b]++] = {edges_[e].a, e};
    }

    for (const Triangle& t : mesh.triangles)
        for (Index v : t)
            ++first_triangle_[v + 1];
    accumulate(first_triangle_);
    triangle_at_.resize(first_triangle_.back());
    next.assign(first_triangle_.begin(), first_triangle_.end() - 1);
    for (Index f = 0; f < mesh.triangles.size(); ++f)
        for (Index v : mesh.triangles[f])
            triangle_at_[next[v]++] = f;
}

std::vector<double> edge_angles(const TriangleMesh& mesh, const EdgeGraph& graph) {
    constexpr std::size_t block = 8192;
    std::vector<Vec3> normals(mesh.triangles.size());
    parallel_blocks(normals.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f)
            normals[f] = area_vector(mesh, f).normalized();
    });
    const std::span<const EdgeGraph::Edge> edges = graph.edges();
    std::vector<double> angles(edges.size(), 0.0);
    parallel_blocks(edges.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const EdgeGraph::Edge& e = edges[i];
            if (e.left == no_index)
                continue;
            const Vec3 along = (mesh.positions[e.b] - mesh.positions[e.a]).normalized();
            const double sine = normals[e.left].cross(normals[e.right]).dot(along);
            angles[i] = std::asin(std::clamp(sine, -1.0, 1.0));
        }
    });
    return angles;
}

} // namespace wm3d::metrics
