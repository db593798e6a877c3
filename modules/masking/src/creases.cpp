// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/masking/creases.hpp>

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include <wm3d/mesh/sides.hpp>

namespace wm3d::masking {

namespace {

/// Radians that a hinge of triangles at an angle may turn.
double limit_of(double angle, const CreaseOptions& options) {
    return options.flat + options.share * angle;
}

} // namespace

Creases::Creases(const TriangleMesh& mesh, std::span<const Vec3> normals)
    : first_(mesh.positions.size() + 1, 0) {
    const std::vector<Side> sides = sorted_sides(mesh);
    hinges_.reserve(sides.size() / 2);
    for_each_edge(sides, [&](std::span<const Side> edge) {
        if (edge.size() == 2)
            add(mesh, normals, {edge[0].low, edge[0].high, opposite(mesh, edge[0]), opposite(mesh, edge[1])});
    });
    for (const Hinge& hinge : hinges_)
        for (Index v : hinge.vertices)
            ++first_[v + 1];
    for (std::size_t v = 1; v < first_.size(); ++v)
        first_[v] += first_[v - 1];
    at_vertex_.resize(first_.back());
    std::vector<Index> next(first_.begin(), first_.end() - 1);
    for (Index h = 0; h < hinges_.size(); ++h)
        for (Index v : hinges_[h].vertices)
            at_vertex_[next[v]++] = h;
}

/// \param vertices  both ends of the edge, and the corners opposite
void Creases::add(const TriangleMesh& mesh, std::span<const Vec3> normals,
                  const std::array<Index, 4>& vertices) {
    constexpr double sliver = 1e-9; // height over the edge
    const auto at = [&](std::size_t k) -> const Vec3& { return mesh.positions[vertices[k]]; };
    const Vec3 edge = at(1) - at(0);
    const double length = edge.norm();
    std::array<Vec3, 2> gradient; // of the angle, by the moves of either corner
    std::array<double, 2> along;  // where the corner's height meets the edge, of its length
    std::array<Vec3, 2> normal;
    for (std::size_t side = 0; side < 2; ++side) {
        const Vec3 to_corner = at(2 + side) - at(0);
        const Vec3 across = side == 0 ? edge.cross(to_corner) : to_corner.cross(edge);
        const double height = length > 0 ? across.norm() / length : 0;
        if (!(height > sliver * length))
            return;
        normal[side] = across / (length * height);
        gradient[side] = normal[side] / height;
        along[side] = edge.dot(to_corner) / (length * length);
    }
    const Vec3 low = -(1 - along[0]) * gradient[0] - (1 - along[1]) * gradient[1];
    const Vec3 high = -along[0] * gradient[0] - along[1] * gradient[1];
    const double angle = std::atan2(normal[0].cross(normal[1]).norm(), normal[0].dot(normal[1]));
    hinges_.push_back({vertices,
                       {low.dot(normals[vertices[0]]), high.dot(normals[vertices[1]]),
                        gradient[0].dot(normals[vertices[2]]), gradient[1].dot(normals[vertices[3]])},
                       angle});
}

double Creases::turn(const Hinge& hinge, std::span<const double> moves) const {
    double sum = 0;
    for (std::size_t k = 0; k < 4; ++k)
        sum += hinge.turns[k] * moves[hinge.vertices[k]];
    return sum;
}

double Creases::worst(std::span<const double> moves, const CreaseOptions& options) const {
    double most = 0;
    for (const Hinge& hinge : hinges_)
        most = std::max(most, std::abs(turn(hinge, moves)) / limit_of(hinge.angle, options));
    return most;
}

std::vector<Index> Creases::turned_too_far(std::span<const double> moves,
                                           const CreaseOptions& options) const {
    std::vector<Index> found;
    for (Index h = 0; h < hinges_.size(); ++h)
        if (std::abs(turn(hinges_[h], moves)) > (1 + options.tolerance) * limit_of(hinges_[h].angle, options))
            found.push_back(h);
    return found;
}

/// The hinges that share a vertex with these, ascending.
std::vector<Index> Creases::around(std::span<const Index> hinges) const {
    std::vector<Index> found;
    for (Index h : hinges)
        for (Index v : hinges_[h].vertices)
            found.insert(found.end(), at_vertex_.begin() + first_[v], at_vertex_.begin() + first_[v + 1]);
    std::ranges::sort(found);
    found.erase(std::unique(found.begin(), found.end()), found.end());
    return found;
}

void Creases::limit(std::vector<double>& moves, const CreaseOptions& options) const {
    std::vector<double> weight(moves.size());
    std::ranges::transform(moves, weight.begin(), [](double m) { return m * m; });
    std::vector<Index> active = turned_too_far(moves, options), changed;
    for (std::size_t round = 0; round < options.most_rounds && !active.empty(); ++round) {
        changed.clear();
        for (Index h : active) {
            const Hinge& hinge = hinges_[h];
            const double turned = turn(hinge, moves), limit = limit_of(hinge.angle, options);
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
        active = around(changed);
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
