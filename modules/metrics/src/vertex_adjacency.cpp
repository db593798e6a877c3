// SPDX-License-Identifier: GPL-3.0-or-later
#include "vertex_adjacency.hpp"

#include <algorithm>
#include <cmath>
#include <tuple>

#include <wm3d/mesh/measure.hpp>

namespace wm3d::metrics {

namespace {

struct Side {
    Index a, b; ///< a < b
    Index triangle;
    bool forward; ///< the triangle walks from a to b

    bool same_edge(const Side& o) const { return a == o.a && b == o.b; }
};

std::vector<Side> sorted_sides(const TriangleMesh& mesh) {
    std::vector<Side> sides;
    sides.reserve(3 * mesh.triangles.size());
    for (Index f = 0; f < mesh.triangles.size(); ++f)
        for (std::size_t k = 0; k < 3; ++k) {
            const Index a = mesh.triangles[f][k], b = mesh.triangles[f][(k + 1) % 3];
            sides.push_back({std::min(a, b), std::max(a, b), f, a < b});
        }
    std::sort(sides.begin(), sides.end(), [](const Side& s, const Side& t) {
        return std::tie(s.a, s.b, s.triangle) < std::tie(t.a, t.b, t.triangle);
    });
    return sides;
}

/// Signed angle from the normal of the triangle that walks a to b to that of its neighbour.
double turning_angle(const TriangleMesh& mesh, const Side& s, const Side& t) {
    if (s.forward == t.forward)
        return 0; // orientations disagree: no outside, no sign
    const Vec3 left = area_vector(mesh, s.forward ? s.triangle : t.triangle);
    const Vec3 right = area_vector(mesh, s.forward ? t.triangle : s.triangle);
    const Vec3 along = (mesh.positions[s.b] - mesh.positions[s.a]).normalized();
    return std::atan2(left.cross(right).dot(along), left.dot(right));
}

} // namespace

VertexAdjacency::VertexAdjacency(const TriangleMesh& mesh) : first_(mesh.positions.size() + 1, 0) {
    const std::vector<Side> sides = sorted_sides(mesh);
    edges_.reserve(sides.size() / 2);
    for (std::size_t i = 0; i < sides.size();) {
        std::size_t end = i + 1;
        while (end < sides.size() && sides[end].same_edge(sides[i]))
            ++end;
        const double angle = end - i == 2 ? turning_angle(mesh, sides[i], sides[i + 1]) : 0;
        edges_.push_back({sides[i].a, sides[i].b, angle});
        i = end;
    }
    for (const CurvedEdge& e : edges_) {
        ++first_[e.a + 1];
        ++first_[e.b + 1];
    }
    for (std::size_t v = 0; v + 1 < first_.size(); ++v)
        first_[v + 1] += first_[v];
    edge_at_.resize(first_.back());
    std::vector<std::size_t> next(first_.begin(), first_.end() - 1);
    for (Index e = 0; e < edges_.size(); ++e) {
        edge_at_[next[edges_[e].a]++] = e;
        edge_at_[next[edges_[e].b]++] = e;
    }
}

std::span<const Index> BallWalk::gather(Index centre, double radius) {
    ++walk_;
    found_.assign(1, centre);
    seen_[centre] = walk_;
    const Vec3& c = mesh_.positions[centre];
    for (std::size_t i = 0; i < found_.size(); ++i) {
        const Index v = found_[i];
        for (Index e : adjacency_.edges_at(v)) {
            const Index w = adjacency_.other_end(e, v);
            if (seen_[w] == walk_ || (mesh_.positions[w] - c).squaredNorm() > radius * radius)
                continue;
            seen_[w] = walk_;
            found_.push_back(w);
        }
    }
    return found_;
}

} // namespace wm3d::metrics
