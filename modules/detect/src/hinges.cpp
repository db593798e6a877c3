// SPDX-License-Identifier: GPL-3.0-or-later
#include "hinges.hpp"

#include <algorithm>
#include <cmath>

#include <Eigen/Geometry>

#include <wm3d/mesh/sides.hpp>

namespace wm3d::detect {

Hinges::Hinges(const TriangleMesh& mesh, std::span<const Vec3> normals) : normals_(normals) {
    const std::vector<Side> sides = sorted_sides(mesh);
    hinges_.reserve(sides.size() / 2);
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
    Hinge hinge{vertices, {c[0], c[1], c[2], c[3]}, {}, normal.normalized(), 0};
    hinge.fold = hinge.normal.dot(c[1] * edge + c[2] * to_left + c[3] * to_right); // c sums to 0
    for (std::size_t k = 0; k < 4; ++k)
        hinge.couplings[k] = c[static_cast<Eigen::Index>(k)] * normals_[vertices[k]].dot(hinge.normal);
    hinges_.push_back(hinge);
}

std::vector<double> Hinges::folds() const {
    std::vector<double> r(hinges_.size());
    std::ranges::transform(hinges_, r.begin(), &Hinge::fold);
    return r;
}

std::vector<double> Hinges::folds_of(std::span<const double> moves) const {
    std::vector<double> r(hinges_.size(), 0.0);
    for (std::size_t h = 0; h < r.size(); ++h)
        for (std::size_t k = 0; k < 4; ++k)
            r[h] += hinges_[h].couplings[k] * moves[hinges_[h].vertices[k]];
    return r;
}

std::vector<double> Hinges::transposed(std::span<const double> y) const {
    std::vector<double> x(normals_.size(), 0.0);
    for (std::size_t h = 0; h < hinges_.size(); ++h)
        for (std::size_t k = 0; k < 4; ++k)
            x[hinges_[h].vertices[k]] += hinges_[h].couplings[k] * y[h];
    return x;
}

std::vector<double> Hinges::squares(std::span<const double> g) const {
    std::vector<double> x(normals_.size(), 0.0);
    for (std::size_t h = 0; h < hinges_.size(); ++h)
        for (std::size_t k = 0; k < 4; ++k)
            x[hinges_[h].vertices[k]] += hinges_[h].couplings[k] * hinges_[h].couplings[k] * g[h];
    return x;
}

std::vector<Vec3> Hinges::gradient(std::span<const double> y) const {
    std::vector<Vec3> x(normals_.size(), Vec3::Zero());
    for (std::size_t h = 0; h < hinges_.size(); ++h)
        for (std::size_t k = 0; k < 4; ++k)
            x[hinges_[h].vertices[k]] += y[h] * hinges_[h].c[k] * hinges_[h].normal;
    return x;
}

} // namespace wm3d::detect
