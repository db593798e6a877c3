// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/masking/creases.hpp>

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include <wm3d/core/filed.hpp>
#include <wm3d/core/parallel.hpp>
#include <wm3d/mesh/sides.hpp>

namespace wm3d::masking {

namespace {

constexpr std::size_t hinge_block = 8192;

/// The vertices of hinges: both ends of the edge, and the corners opposite.
using HingeVertices = std::vector<std::array<Index, 4>>;

/// Hinges by their vertices, `count` of them.
Filed<Index> by_vertex(const HingeVertices& vertices, std::size_t count) {
    return filed<Index>(count, vertices.size(), [&](auto&& file) {
        for (Index h = 0; h < vertices.size(); ++h)
            for (Index v : vertices[h])
                file(v, [&] { return h; });
    });
}

/// The hinges that share a vertex with these, ascending.
std::vector<Index> around(std::span<const Index> changed, const HingeVertices& vertices,
                          const Filed<Index>& by_vertex) {
    std::vector<Index> found;
    for (Index h : changed)
        for (Index v : vertices[h]) {
            const std::span<const Index> there = by_vertex.under(v);
            found.insert(found.end(), there.begin(), there.end());
        }
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

} // namespace

Creases::Creases(const TriangleMesh& mesh, std::span<const Vec3> normals) : mesh_(mesh), normals_(normals) {
    const std::vector<Side> sides = sorted_sides(mesh);
    vertices_.reserve(sides.size() / 2);
    for_each_edge(sides, [&](std::span<const Side> edge) {
        if (edge.size() == 2)
            vertices_.push_back(
                {edge[0].low, edge[0].high, opposite(mesh, edge[0]), opposite(mesh, edge[1])});
    });
}

Creases::Hinge Creases::hinge(Index h) const {
    constexpr double sliver = 1e-9; // height over the edge
    Hinge hinge{vertices_[h], {}, {Vec3::Zero(), Vec3::Zero()}};
    const auto at = [&](std::size_t k) -> const Vec3& { return mesh_.positions[hinge.vertices[k]]; };
    const Vec3 edge = at(1) - at(0);
    const double length = edge.norm();
    std::array<Vec3, 2> gradient; // of the angle, by the moves of either corner
    std::array<double, 2> along;  // where the corner's height meets the edge, of its length
    for (std::size_t side = 0; side < 2; ++side) {
        const Vec3 to_corner = at(2 + side) - at(0);
        const Vec3 across = side == 0 ? edge.cross(to_corner) : to_corner.cross(edge);
        const double height = length > 0 ? across.norm() / length : 0;
        if (!(height > sliver * length))
            return hinge;
        hinge.normals[side] = across / (length * height);
        gradient[side] = hinge.normals[side] / height;
        along[side] = edge.dot(to_corner) / (length * length);
    }
    const Vec3 low = -(1 - along[0]) * gradient[0] - (1 - along[1]) * gradient[1];
    const Vec3 high = -along[0] * gradient[0] - along[1] * gradient[1];
    const auto along_normal = [&](const Vec3& g, std::size_t k) {
        return g.dot(normals_[hinge.vertices[k]]);
    };
    hinge.turns = {along_normal(low, 0), along_normal(high, 1), along_normal(gradient[0], 2),
                   along_normal(gradient[1], 3)};
    return hinge;
}

/// Radians, to first order in the moves.
double Creases::Hinge::turn(std::span<const double> moves) const {
    double sum = 0;
    for (std::size_t k = 0; k < 4; ++k)
        sum += turns[k] * moves[vertices[k]];
    return sum;
}

/// Radians that it may turn, by the angle between its triangles.
double Creases::Hinge::limit(const CreaseOptions& options) const {
    const double angle = std::atan2(normals[0].cross(normals[1]).norm(), normals[0].dot(normals[1]));
    return options.flat + options.share * angle;
}

double Creases::worst(std::span<const double> moves, const CreaseOptions& options) const {
    double most = 0;
    for (Index h = 0; h < vertices_.size(); ++h) {
        const Hinge hinge = this->hinge(h);
        most = std::max(most, std::abs(hinge.turn(moves)) / hinge.limit(options));
    }
    return most;
}

/// Ascending.
std::vector<Index> Creases::turned_too_far(std::span<const double> moves,
                                           const CreaseOptions& options) const {
    const double tolerated = 1 + options.tolerance;
    std::vector<std::vector<Index>> of_block((vertices_.size() + hinge_block - 1) / hinge_block);
    parallel_blocks(vertices_.size(), hinge_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t h = begin; h < end; ++h) {
            const Hinge hinge = this->hinge(static_cast<Index>(h));
            const double turned = std::abs(hinge.turn(moves));
            if (turned > tolerated * options.flat && turned > tolerated * hinge.limit(options))
                of_block[begin / hinge_block].push_back(static_cast<Index>(h));
        }
    });
    std::vector<Index> found;
    for (const std::vector<Index>& block : of_block)
        found.insert(found.end(), block.begin(), block.end());
    return found;
}

void Creases::limit(std::vector<double>& moves, const CreaseOptions& options) const {
    std::vector<Index> active, changed;
    Filed<Index> hinges_of;
    parallel_invoke([&] { active = turned_too_far(moves, options); },
                    [&] { hinges_of = by_vertex(vertices_, mesh_.positions.size()); });
    if (active.empty())
        return;
    std::vector<double> weight(moves.size());
    std::ranges::transform(moves, weight.begin(), [](double m) { return m * m; });
    for (std::size_t round = 0; round < options.most_rounds && !active.empty(); ++round) {
        changed.clear();
        for (Index h : active) {
            const Hinge hinge = this->hinge(h);
            const double turned = hinge.turn(moves), limit = hinge.limit(options);
            const double excess = std::abs(turned) - limit;
            if (excess <= options.tolerance * limit)
                continue;
            double square = 0;
            for (std::size_t k = 0; k < 4; ++k)
                square += weight[hinge.vertices[k]] * hinge.turns[k] * hinge.turns[k];
            for (std::size_t k = 0; k < 4; ++k)
                moves[hinge.vertices[k]] -=
                    std::copysign(excess, turned) * weight[hinge.vertices[k]] * hinge.turns[k] / square;
            changed.push_back(h);
        }
        active = around(changed, vertices_, hinges_of);
    }
}

std::vector<Vec3> without_creases(const Creases& creases, const TriangleMesh& mesh,
                                  std::span<const Vec3> normals, std::vector<Vec3> moved,
                                  const CreaseOptions& options) {
    std::vector<double> moves(moved.size());
    for (std::size_t i = 0; i < moves.size(); ++i)
        moves[i] = normals[i].dot(moved[i] - mesh.positions[i]);
    std::vector<double> kept = moves;
    creases.limit(kept, options);
    for (std::size_t i = 0; i < moves.size(); ++i)
        if (kept[i] != moves[i])
            moved[i] += (kept[i] - moves[i]) * normals[i];
    return moved;
}

} // namespace wm3d::masking
