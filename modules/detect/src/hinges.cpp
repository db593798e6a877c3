// SPDX-License-Identifier: GPL-3.0-or-later
#include "hinges.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <Eigen/Geometry>

namespace wm3d::detect {

namespace {

/// An edge as one triangle has it, and the corner opposite.
struct Side {
    Index low, high, opposite;
    friend auto operator<=>(const Side&, const Side&) = default;
};

/// The sides of all triangles in ascending order, so those of one edge together.
std::vector<Side> sorted_sides(const TriangleMesh& mesh) {
    // Filed under their lower ends: what is left to sort are the few at one vertex.
    std::vector<std::size_t> end(mesh.positions.size() + 1, 0);
    const auto for_each_side = [&](auto&& visit) {
        for (const Triangle& t : mesh.triangles)
            for (std::size_t k = 0; k < 3; ++k)
                visit(Side{std::min(t[k], t[(k + 1) % 3]), std::max(t[k], t[(k + 1) % 3]), t[(k + 2) % 3]});
    };
    for_each_side([&](const Side& s) { ++end[s.low + 1]; });
    std::partial_sum(end.begin(), end.end(), end.begin());
    std::vector<Side> sides(end.back());
    for_each_side([&](const Side& s) { sides[end[s.low]++] = s; });
    for (std::size_t v = 0, begin = 0; v + 1 < end.size(); begin = end[v++])
        std::sort(sides.begin() + static_cast<std::ptrdiff_t>(begin),
                  sides.begin() + static_cast<std::ptrdiff_t>(end[v]));
    return sides;
}

} // namespace

Hinges::Hinges(const TriangleMesh& mesh, std::span<const Vec3> normals) : normals_(normals) {
    const std::vector<Side> sides = sorted_sides(mesh);
    hinges_.reserve(sides.size() / 2);
    for (std::size_t first = 0, last = 0; first < sides.size(); first = last) {
        while (last < sides.size() && sides[last].low == sides[first].low &&
               sides[last].high == sides[first].high)
            ++last;
        if (last - first == 2)
            add(mesh,
                {sides[first].low, sides[first].high, sides[first].opposite, sides[first + 1].opposite});
    }
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
    Hinge hinge{vertices, {c[0], c[1], c[2], c[3]}, normal.normalized(), 0};
    hinge.fold = hinge.normal.dot(c[1] * edge + c[2] * to_left + c[3] * to_right); // c sums to 0
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
        for (std::size_t k = 0; k < 4; ++k) {
            const Index v = hinges_[h].vertices[k];
            r[h] += hinges_[h].c[k] * normals_[v].dot(hinges_[h].normal) * moves[v];
        }
    return r;
}

std::vector<double> Hinges::transposed(std::span<const double> y) const {
    std::vector<double> x(normals_.size(), 0.0);
    for (std::size_t h = 0; h < hinges_.size(); ++h)
        for (std::size_t k = 0; k < 4; ++k) {
            const Index v = hinges_[h].vertices[k];
            x[v] += hinges_[h].c[k] * normals_[v].dot(hinges_[h].normal) * y[h];
        }
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
