// SPDX-License-Identifier: GPL-3.0-or-later
#include "triangle_boxes.hpp"

#include <algorithm>
#include <array>

#include <wm3d/core/parallel.hpp>

#include "closest_on_triangle.hpp"

namespace wm3d::metrics {

namespace {

constexpr std::size_t leaf_size = 4; // at most
constexpr std::size_t worth_a_thread = 8192;

/// The number of nodes of the least perfect tree whose leaves hold `count` triangles.
std::size_t nodes_for(std::size_t count) {
    std::size_t leaves = 1;
    while (leaves * leaf_size < count)
        leaves *= 2;
    return 2 * leaves - 1;
}

/// Three times the centroids of all triangles, #F.
std::vector<Vec3> centroids(const TriangleMesh& mesh) {
    std::vector<Vec3> centres(mesh.triangles.size());
    for (std::size_t f = 0; f < centres.size(); ++f) {
        const Triangle& t = mesh.triangles[f];
        centres[f] = mesh.positions[t[0]] + mesh.positions[t[1]] + mesh.positions[t[2]];
    }
    return centres;
}

std::size_t middle(std::size_t begin, std::size_t end) {
    return begin + (end - begin + 1) / 2;
}

} // namespace

void NearestTriangle::improve(const Vec3& query, const NumberedTriangle& other) {
    const double other_square = squared_distance_to_triangle(query, other.a, other.b, other.c);
    if (!may_yield_to(other_square))
        return;
    const Vec3 normal = (other.b - other.a).cross(other.c - other.a);
    const double along = normal.dot(query - other.a), other_height = along * along / normal.squaredNorm();
    const bool closer = other_square < square * (1 - same);
    const bool squarer = other_height > height * (1 + same);
    const bool as_square = other_height >= height * (1 - same);
    if (closer || squarer || (as_square && other.number < triangle))
        *this = {other.number, other_square, other_height};
}

TriangleBoxes::TriangleBoxes(const TriangleMesh& mesh, std::vector<Index> triangles)
    : mesh_(mesh), triangles_(std::move(triangles)), boxes_(nodes_for(triangles_.size())) {
    build(0, 0, triangles_.size(), centroids(mesh));
}

NumberedTriangle TriangleBoxes::numbered(Index triangle) const {
    const Triangle& t = mesh_.triangles[triangle];
    return {mesh_.positions[t[0]], mesh_.positions[t[1]], mesh_.positions[t[2]], triangle};
}

void TriangleBoxes::build(std::size_t node, std::size_t begin, std::size_t end,
                          const std::vector<Vec3>& centres) {
    const auto at = [&](std::size_t i) { return triangles_.begin() + static_cast<std::ptrdiff_t>(i); };
    const Vec3& somewhere = mesh_.positions[mesh_.triangles[triangles_[begin]][0]];
    Box box{somewhere, somewhere}, around{centres[triangles_[begin]], centres[triangles_[begin]]};
    std::for_each(at(begin), at(end), [&](Index f) {
        for (Index v : mesh_.triangles[f]) {
            box.min = box.min.cwiseMin(mesh_.positions[v]);
            box.max = box.max.cwiseMax(mesh_.positions[v]);
        }
        around.min = around.min.cwiseMin(centres[f]);
        around.max = around.max.cwiseMax(centres[f]);
    });
    boxes_[node] = box;
    if (is_leaf(node))
        return;
    // Half of the triangles on either side of the widest direction's median.
    Eigen::Index axis = 0;
    (around.max - around.min).maxCoeff(&axis);
    const std::size_t half = middle(begin, end);
    std::nth_element(at(begin), at(half), at(end), [&](Index s, Index t) {
        const double x = centres[s][axis], y = centres[t][axis];
        return x < y || (x == y && s < t);
    });
    const auto left = [&] { build(2 * node + 1, begin, half, centres); };
    const auto right = [&] { build(2 * node + 2, half, end, centres); };
    if (end - begin > worth_a_thread)
        parallel_invoke(left, right);
    else {
        left();
        right();
    }
}

template<typename Wanted>
NearestTriangle TriangleBoxes::search(const Vec3& query, NearestTriangle known, Wanted&& wanted) const {
    struct Pending {
        std::size_t node, begin, end;
        double square; ///< of the distance to the node's box
    };
    std::array<Pending, 64> stack; // the tree is balanced: never deeper than the bits of a count
    std::size_t size = 0;
    stack[size++] = {0, 0, triangles_.size(), boxes_[0].squared_distance(query)};
    while (size > 0) {
        const Pending at = stack[--size];
        if (!known.may_yield_to(at.square))
            continue;
        if (is_leaf(at.node)) {
            for (std::size_t i = at.begin; i < at.end; ++i)
                if (wanted(triangles_[i]))
                    known.improve(query, numbered(triangles_[i]));
            continue;
        }
        const std::size_t left = 2 * at.node + 1, half = middle(at.begin, at.end);
        Pending near{left, at.begin, half, boxes_[left].squared_distance(query)};
        Pending far{left + 1, half, at.end, boxes_[left + 1].squared_distance(query)};
        if (far.square < near.square)
            std::swap(near, far);
        if (known.may_yield_to(far.square))
            stack[size++] = far;
        if (known.may_yield_to(near.square))
            stack[size++] = near;
    }
    return known;
}

NearestTriangle TriangleBoxes::nearest(const Vec3& query, NearestTriangle known) const {
    return search(query, known, [](Index) { return true; });
}

NearestTriangle TriangleBoxes::nearest_but(std::span<const Index> left_out, const Vec3& query,
                                           double square) const {
    return search(query, {no_index, square},
                  [&](Index f) { return std::ranges::find(left_out, f) == left_out.end(); });
}

} // namespace wm3d::metrics
