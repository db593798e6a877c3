// SPDX-License-Identifier: GPL-3.0-or-later
#include "hinges.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include <wm3d/mesh/sides.hpp>

namespace wm3d::detect {

Hinges::Hinges(const TriangleMesh& mesh, std::span<const Vec3> normals) : normals_(normals) {
    const std::vector<Side> sides = sorted_sides(mesh);
    const std::size_t most = sides.size() / 2;
    ends_.reserve(most);
    c_.reserve(most);
    couplings_.reserve(most);
    fold_normals_.reserve(most);
    folds_.reserve(most);
    for_each_edge(sides, [&](std::span<const Side> edge) {
        if (edge.size() != 2)
            return;
        const auto [left, right] = std::minmax({opposite(mesh, edge[0]), opposite(mesh, edge[1])});
        add(mesh, {edge[0].low, edge[0].high, left, right});
    });
}

void Hinges::add(const TriangleMesh& mesh, const std::array<Index, 4>& vertices) {
    constexpr double flat = 1e-12, folded_back = 1e-6; // heights over lengths; sum of the unit normals
    const auto at = [&](std::size_t k) -> const Vec3& { return mesh.positions[vertices[k]]; };
    const Vec3 edge = at(1) - at(0), to_left = at(2) - at(0), to_right = at(3) - at(0);
    const double square = edge.squaredNorm();
    if (!(square > 0))
        return;
    const Vec3 left = edge.cross(to_left), right = to_right.cross(edge);
    const double left_height = left.norm(), right_height = right.norm(); // times the length of the edge
    if (!(left_height > flat * square && right_height > flat * square))
        return;
    const Vec3 normal = left / left_height + right / right_height;
    if (!(normal.norm() > folded_back))
        return;
    // Unfolded, the line between the opposite corners meets the edge's at this part of each.
    const double across = left_height / (left_height + right_height);
    const double along = std::lerp(edge.dot(to_left), edge.dot(to_right), across) / square;
    const Eigen::Vector4d c = Eigen::Vector4d(along - 1, -along, 1 - across, across).normalized();
    const Vec3 unit = normal.normalized();
    ends_.push_back(vertices);
    c_.push_back({c[0], c[1], c[2], c[3]});
    folds_.push_back(unit.dot(c[1] * edge + c[2] * to_left + c[3] * to_right)); // c sums to 0
    std::array<double, 4>& coupling = couplings_.emplace_back();
    for (std::size_t k = 0; k < 4; ++k)
        coupling[k] = c_.back()[k] * normals_[vertices[k]].dot(unit);
    fold_normals_.push_back(unit);
}

std::vector<double> Hinges::folds_of(std::span<const double> moves) const {
    std::vector<double> r(size(), 0.0);
    for (std::size_t h = 0; h < r.size(); ++h)
        for (std::size_t k = 0; k < 4; ++k)
            r[h] += couplings_[h][k] * moves[ends_[h][k]];
    return r;
}

std::vector<double> Hinges::transposed(std::span<const double> y) const {
    std::vector<double> x(normals_.size(), 0.0);
    for (std::size_t h = 0; h < size(); ++h)
        for (std::size_t k = 0; k < 4; ++k)
            x[ends_[h][k]] += couplings_[h][k] * y[h];
    return x;
}

std::vector<double> Hinges::squares(std::span<const double> g) const {
    std::vector<double> x(normals_.size(), 0.0);
    for (std::size_t h = 0; h < size(); ++h)
        for (std::size_t k = 0; k < 4; ++k)
            x[ends_[h][k]] += couplings_[h][k] * couplings_[h][k] * g[h];
    return x;
}

std::vector<Vec3> Hinges::gradient(std::span<const double> y) const {
    std::vector<Vec3> x(normals_.size(), Vec3::Zero());
    for (std::size_t h = 0; h < size(); ++h)
        for (std::size_t k = 0; k < 4; ++k)
            x[ends_[h][k]] += y[h] * c_[h][k] * fold_normals_[h];
    return x;
}

} // namespace wm3d::detect
