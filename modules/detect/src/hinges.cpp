// SPDX-License-Identifier: GPL-3.0-or-later
#include "hinges.hpp"

#include <algorithm>
#include <cmath>
#include <optional>

#include <Eigen/Geometry>

#include "edge_order.hpp"

namespace wm3d::detect {

namespace {

/// A hinge as the vertices lie. Of c and n no more is told than their products.
struct Fold {
    std::array<double, 4> c{};
    Vec3 normal = Vec3::Zero(); ///< n over the length of this c
    double size = 0;            ///< r
};

/// Nothing of vertices that make no hinge.
std::optional<Fold> fold_of(std::span<const Vec3> positions, const std::array<Index, 4>& vertices) {
    constexpr double flat = 1e-12, folded_back = 1e-6; // heights over lengths; sum of the unit normals
    const auto at = [&](std::size_t k) -> const Vec3& { return positions[vertices[k]]; };
    const Vec3 edge = at(1) - at(0), to_left = at(2) - at(0), to_right = at(3) - at(0);
    const double square = edge.squaredNorm();
    if (!(square > 0))
        return std::nullopt;
    const Vec3 left = edge.cross(to_left), right = to_right.cross(edge);
    const double left_height = left.norm(), right_height = right.norm(); // times the length of the edge
    if (!(left_height > flat * square && right_height > flat * square))
        return std::nullopt;
    // The sum of the unit normals, times both heights.
    const Vec3 normal = right_height * left + left_height * right;
    const double folded = folded_back * left_height * right_height;
    if (!(normal.squaredNorm() > folded * folded))
        return std::nullopt;
    // Unfolded, the line between the opposite corners meets the edge's at `along` of the one and left_height /
    // (left_height + right_height) of the other; all of c is times what these would be divided by.
    const double whole = square * (left_height + right_height);
    const double along = right_height * edge.dot(to_left) + left_height * edge.dot(to_right);
    const Eigen::Vector4d c(along - whole, -along, square * right_height, square * left_height);
    const double lengths = c.squaredNorm() * normal.squaredNorm();
    if (!(lengths > 0))
        return std::nullopt;
    const Vec3 scaled = normal / std::sqrt(lengths);
    return Fold{{c[0], c[1], c[2], c[3]},
                scaled,
                scaled.dot(c[1] * edge + c[2] * to_left + c[3] * to_right)}; // c sums to 0
}

} // namespace

Hinges::Hinges(const TriangleMesh& mesh, std::span<const Vec3> normals) : vertices_(normals.size()) {
    const Filed<Spoke<Index>> upward =
        upward_spokes<Index>(mesh, [&](std::size_t f, std::size_t k) { return mesh.triangles[f][k]; });
    const std::size_t most = upward.values.size() / 2;
    ends_.reserve(most);
    couplings_.reserve(most);
    folds_.reserve(most);
    for_each_edge(upward, [&](Index low, Index high, std::span<const Spoke<Index>> corners) {
        if (corners.size() != 2)
            return;
        const auto [left, right] = std::minmax({corners[0].value, corners[1].value});
        const std::array<Index, 4> ends{low, high, left, right};
        const std::optional<Fold> fold = fold_of(mesh.positions, ends);
        if (!fold)
            return;
        ends_.push_back(ends);
        folds_.push_back(fold->size);
        std::array<double, 4>& coupling = couplings_.emplace_back();
        for (std::size_t k = 0; k < 4; ++k)
            coupling[k] = fold->c[k] * normals[ends[k]].dot(fold->normal);
    });
}

std::vector<double> Hinges::folds_of(std::span<const double> moves) const {
    std::vector<double> r(size(), 0.0);
    for (std::size_t h = 0; h < r.size(); ++h)
        for (std::size_t k = 0; k < 4; ++k)
            r[h] += couplings_[h][k] * moves[ends_[h][k]];
    return r;
}

std::vector<double> Hinges::transposed(std::span<const double> y) const {
    std::vector<double> x(vertices_, 0.0);
    for (std::size_t h = 0; h < size(); ++h)
        for (std::size_t k = 0; k < 4; ++k)
            x[ends_[h][k]] += couplings_[h][k] * y[h];
    return x;
}

std::vector<double> Hinges::squares(std::span<const double> g) const {
    std::vector<double> x(vertices_, 0.0);
    for (std::size_t h = 0; h < size(); ++h)
        for (std::size_t k = 0; k < 4; ++k)
            x[ends_[h][k]] += couplings_[h][k] * couplings_[h][k] * g[h];
    return x;
}

std::vector<Vec3> Hinges::gradient(std::span<const Vec3> positions, std::span<const double> y) const {
    std::vector<Vec3> x(vertices_, Vec3::Zero());
    for (std::size_t h = 0; h < size(); ++h)
        if (const std::optional<Fold> fold = fold_of(positions, ends_[h]))
            for (std::size_t k = 0; k < 4; ++k)
                x[ends_[h][k]] += y[h] * fold->c[k] * fold->normal;
    return x;
}

} // namespace wm3d::detect
