// SPDX-License-Identifier: GPL-3.0-or-later
#include "fan.hpp"

#include <map>
#include <numeric>

#include <wm3d/mesh/neighbours.hpp>

namespace wm3d::attack {

namespace {

/// Disjoint sets of vertices.
class Sets {
public:
    explicit Sets(std::size_t count) : parent_(count) { std::iota(parent_.begin(), parent_.end(), Index{0}); }

    Index find(Index v) {
        while (parent_[v] != v)
            v = parent_[v] = parent_[parent_[v]];
        return v;
    }
    void unite(Index a, Index b) { parent_[find(a)] = find(b); }

private:
    std::vector<Index> parent_;
};

struct Hole {
    Vec3 sum = Vec3::Zero();
    double ends = 0;
    Index centre = no_index;
};

} // namespace

TriangleMesh close_with_fans(const TriangleMesh& mesh) {
    const std::vector<Edge> edges = edges_of(mesh);
    Sets sets(mesh.positions.size());
    for (const Edge& e : edges)
        if (e.faces == 1)
            sets.unite(e.a, e.b);
    std::map<Index, Hole> holes;
    for (const Edge& e : edges)
        if (e.faces == 1) {
            Hole& hole = holes[sets.find(e.a)];
            hole.sum += mesh.positions[e.a] + mesh.positions[e.b];
            hole.ends += 2;
        }
    TriangleMesh closed = mesh;
    for (auto& [root, hole] : holes) {
        hole.centre = static_cast<Index>(closed.positions.size());
        closed.positions.push_back(hole.sum / hole.ends);
    }
    for (const Edge& e : edges)
        if (e.faces == 1)
            closed.triangles.push_back({e.b, e.a, holes[sets.find(e.a)].centre});
    return closed;
}

} // namespace wm3d::attack
