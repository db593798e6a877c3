// SPDX-License-Identifier: GPL-3.0-or-later
#include "edge_graph.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <utility>

#include <wm3d/core/parallel.hpp>

namespace wm3d::metrics {

namespace {

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

/// With e the edge and p and q what lies from its lower end to the other corners of its triangles, left and right, their normals
/// are e x p and q x e, and (e x p) x (q x e) is -det(e, p, q) e.
Bend bend_at(const TriangleMesh& mesh, const EdgeGraph::Edge& edge) {
    const auto from_low = [&](Index vertex) -> Vec3 {
        return mesh.positions[vertex] - mesh.positions[edge.a];
    };
    const auto opposite = [&](Index triangle) {
        const Triangle& t = mesh.triangles[triangle];
        return t[0] ^ t[1] ^ t[2] ^ edge.a ^ edge.b;
    };
    const Vec3 e = from_low(edge.b), p = from_low(opposite(edge.left)), q = from_low(opposite(edge.right));
    const Vec3 left = e.cross(p);
    const double areas = left.squaredNorm() * e.cross(q).squaredNorm(); // of both parallelograms, squared
    if (!(areas >= std::numeric_limits<double>::min()))
        return {};
    const double length = e.norm(), per_length = 1 / length;
    const double sine = -left.dot(q) * length / std::sqrt(areas);
    return {std::asin(std::clamp(sine, -1.0, 1.0)) * per_length, per_length};
}

} // namespace

void EdgeGraph::assign(const TriangleMesh& mesh) {
    file_triangles(mesh);
    list_edges(mesh);
    file_ways(mesh.positions.size());
}

void EdgeGraph::file_triangles(const TriangleMesh& mesh) {
    file_into(triangles_, mesh.positions.size(), 3 * mesh.triangles.size(), [&](auto&& file) {
        for (Index f = 0; f < mesh.triangles.size(); ++f)
            for (const Index v : mesh.triangles[f])
                file(v, [&] { return f; });
    });
}

/// By their lower ends, then by the others.
void EdgeGraph::list_edges(const TriangleMesh& mesh) {
    edges_.clear();
    edges_.reserve(3 * mesh.triangles.size() / 2);
    EdgesAbove above;
    for (Index low = 0; low < mesh.positions.size(); ++low)
        above.for_each(low, triangles_at(low), mesh, [&](const Edge& edge) { edges_.push_back(edge); });
}

/// The edges under both of their ends.
void EdgeGraph::file_ways(std::size_t vertices) {
    file_into(ways_, vertices, 2 * edges_.size(), [&](auto&& file) {
        for (Index e = 0; e < edges_.size(); ++e) {
            file(edges_[e].a, [&] { return Way{edges_[e].b, e}; });
            file(edges_[e].b, [&] { return Way{edges_[e].a, e}; });
        }
    });
}

void make_bends(const TriangleMesh& mesh, const EdgeGraph& graph, std::vector<Bend>& bends) {
    const std::span<const EdgeGraph::Edge> edges = graph.edges();
    bends.assign(edges.size(), {});
    parallel_blocks(edges.size(), 8192, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            if (edges[i].left != no_index)
                bends[i] = bend_at(mesh, edges[i]);
    });
}

} // namespace wm3d::metrics
