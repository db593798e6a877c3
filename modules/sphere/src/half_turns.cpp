// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/sphere/half_turns.hpp>

#include <algorithm>
#include <numeric>

#include <wm3d/core/parallel.hpp>

namespace wm3d::sphere {

namespace {

bool before(const Vec3& a, const Vec3& b) {
    for (int k = 0; k < 3; ++k)
        if (a[k] != b[k])
            return a[k] < b[k];
    return false;
}

/// Half turn about an axis: the signs of the other two coordinates change, which is exact.
Vec3 turned(const Vec3& p, std::size_t axis) {
    Vec3 q = -p;
    q[static_cast<Eigen::Index>(axis)] = p[static_cast<Eigen::Index>(axis)];
    return q;
}

/// The sphere's vertices by their coordinates.
class Directory {
public:
    explicit Directory(const std::vector<Vec3>& vertices) : vertices_(vertices), sorted_(vertices.size()) {
        std::iota(sorted_.begin(), sorted_.end(), Index{0});
        std::ranges::sort(sorted_, before, [&](Index v) -> const Vec3& { return vertices_[v]; });
    }

    Index operator[](const Vec3& p) const {
        return *std::ranges::lower_bound(sorted_, p, before,
                                         [&](Index v) -> const Vec3& { return vertices_[v]; });
    }

private:
    const std::vector<Vec3>& vertices_;
    std::vector<Index> sorted_;
};

} // namespace

std::array<std::vector<Index>, 3> half_turns(const Icosphere& sphere) {
    const Directory vertex_at(sphere.vertices());
    std::array<std::vector<Index>, 3> turns;
    parallel_blocks(3, 1, [&](std::size_t axis, std::size_t) {
        turns[axis].reserve(sphere.vertices().size());
        for (const Vec3& vertex : sphere.vertices())
            turns[axis].push_back(vertex_at[turned(vertex, axis)]);
    });
    return turns;
}

std::vector<Index> inversion(const Icosphere& sphere) {
    const Directory vertex_at(sphere.vertices());
    std::vector<Index> opposite;
    opposite.reserve(sphere.vertices().size());
    for (const Vec3& vertex : sphere.vertices())
        opposite.push_back(vertex_at[-vertex]);
    return opposite;
}

std::optional<int> half_turn_axis(const Mat3& rotation) {
    for (int axis = 0; axis < 3; ++axis) {
        Vec3 diagonal = -Vec3::Ones();
        diagonal[axis] = 1;
        if ((rotation - Mat3(diagonal.asDiagonal())).cwiseAbs().maxCoeff() < 1e-12)
            return axis;
    }
    return std::nullopt;
}

} // namespace wm3d::sphere
