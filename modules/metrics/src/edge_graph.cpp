// SPDX-License-Identifier: GPL-3.0-or-later
#include "edge_graph.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <wm3d/core/parallel.hpp>
#include <wm3d/mesh/measure.hpp>

namespace wm3d::metrics {

namespace {

/// Turns counts, #groups + 1 with the first 0, into where each group begins.
void accumulate(std::vector<std::size_t>& counts) {
    for (std::size_t i = 0; i + 1 < counts.size(); ++i)
        counts[i + 1] += counts[i];
}

/// A triangle's side from one vertex up to another of a higher number, or down from there.
struct Side {
    Index high, triangle;
};

/// Sides at one vertex, by their upper ends and then in the order of their triangles.
class Sides {
public:
    /// Room for as many.
    void clear(std::size_t most) {
        if (sides_.size() <= most)
            sides_.resize(2 * most + 1);
        count_ = 0;
    }

    /// Keeps it if it is one of those. About half are, which no processor foresees: all are written down.
    void add(Side side, bool is_one) {
        sides_[count_] = side;
        count_ += is_one;
    }

    std::span<const Side> sorted() {
        const std::span<Side> sides(sides_.data(), count_);
        if (sides.size() > few)
            std::ranges::stable_sort(sides, {}, &Side::high);
        else
            for (std::size_t i = 1; i < sides.size(); ++i)
                for (std::size_t j = i; j > 0 && sides[j].high < sides[j - 1].high; --j)
                    std::swap(sides[j], sides[j - 1]);
        return sides;
    }

private:
    static constexpr std::size_t few = 32; ///< that are sorted by insertion
    std::vector<Side> sides_;              ///< and room for one more
    std::size_t count_ = 0;
};

/// How many at the front share their upper end.
std::size_t leading(std::span<const Side> sides, Index high) {
    std::size_t count = 0;
    while (count < sides.size() && sides[count].high == high)
        ++count;
    return count;
}

/// The edges from one vertex up to others.
class EdgesAbove {
public:
    /// Calls visit(edge) for each, ascending.
    /// \param triangles  of the vertex, ascending
    template<typename Visitor>
    void for_each(Index low, std::span<const Index> triangles, const TriangleMesh& mesh, Visitor&& visit) {
        gather(low, triangles, mesh);
        std::span<const Side> up = up_.sorted(), down = down_.sorted();
        while (!up.empty() || !down.empty()) {
            const Index high =
                std::min(up.empty() ? no_index : up[0].high, down.empty() ? no_index : down[0].high);
            const std::size_t ups = leading(up, high), downs = leading(down, high);
            EdgeGraph::Edge edge{low, high};
            if (ups == 1 && downs == 1) {
                edge.left = up[0].triangle;
                edge.right = down[0].triangle;
            }
            visit(edge);
            up = up.subspan(ups);
            down = down.subspan(downs);
        }
    }

private:
    void gather(Index low, std::span<const Index> triangles, const TriangleMesh& mesh) {
        up_.clear(triangles.size());
        down_.clear(triangles.size());
        std::size_t corner = 0;
        Index before = no_index;
        for (const Index f : triangles) {
            const Triangle& t = mesh.triangles[f];
            if (f == before) // the triangle has the vertex once more
                corner = corner == 0 && t[1] == low ? 1 : 2;
            else
                corner = t[0] == low ? 0 : t[1] == low ? 1 : 2;
            const Index next = t[(corner + 1) % 3], last = t[(corner + 2) % 3];
            up_.add({next, f}, next > low);
            down_.add({last, f}, last > low);
            before = f;
        }
    }

    Sides up_, down_;
};

} // namespace

EdgeGraph::EdgeGraph(const TriangleMesh& mesh)
    : first_way_(mesh.positions.size() + 1, 0), first_triangle_(mesh.positions.size() + 1, 0) {
    file_triangles(mesh);
    list_edges(mesh);
    file_ways();
}

void EdgeGraph::file_triangles(const TriangleMesh& mesh) {
    for (const Triangle& t : mesh.triangles)
        for (const Index v : t)
            ++first_triangle_[v + 1];
    accumulate(first_triangle_);
    triangle_at_.resize(first_triangle_.back());
    std::vector<std::size_t> next(first_triangle_.begin(), first_triangle_.end() - 1);
    for (Index f = 0; f < mesh.triangles.size(); ++f)
        for (const Index v : mesh.triangles[f])
            triangle_at_[next[v]++] = f;
}

/// By their lower ends, then by the others; counts the ways.
void EdgeGraph::list_edges(const TriangleMesh& mesh) {
    edges_.reserve(3 * mesh.triangles.size() / 2);
    EdgesAbove above;
    for (Index low = 0; low < mesh.positions.size(); ++low)
        above.for_each(low, triangles_at(low), mesh, [&](const Edge& edge) {
            edges_.push_back(edge);
            ++first_way_[edge.a + 1];
            ++first_way_[edge.b + 1];
        });
}

/// The edges under both of their ends.
void EdgeGraph::file_ways() {
    accumulate(first_way_);
    ways_.resize(first_way_.back());
    std::vector<std::size_t> next(first_way_.begin(), first_way_.end() - 1);
    for (Index e = 0; e < edges_.size(); ++e) {
        ways_[next[edges_[e].a]++] = {edges_[e].b, e};
        ways_[next[edges_[e].b]++] = {edges_[e].a, e};
    }
}

std::vector<Bend> bends_of(const TriangleMesh& mesh, const EdgeGraph& graph) {
    constexpr std::size_t block = 8192;
    std::vector<Vec3> normals(mesh.triangles.size());
    parallel_blocks(normals.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f)
            normals[f] = area_vector(mesh, f).normalized();
    });
    const std::span<const EdgeGraph::Edge> edges = graph.edges();
    std::vector<Bend> bends(edges.size());
    parallel_blocks(edges.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            const EdgeGraph::Edge& e = edges[i];
            const Vec3 along = mesh.positions[e.b] - mesh.positions[e.a];
            const double square = along.squaredNorm();
            if (e.left == no_index || !(square >= std::numeric_limits<double>::min()))
                continue;
            const double per_length = 1 / std::sqrt(square);
            const double sine = normals[e.left].cross(normals[e.right]).dot(along) * per_length;
            bends[i] = {std::asin(std::clamp(sine, -1.0, 1.0)) * per_length, per_length * per_length};
        }
    });
    return bends;
}

} // namespace wm3d::metrics
