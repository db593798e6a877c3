// SPDX-License-Identifier: GPL-3.0-or-later
#include "triangle_boxes.hpp"

#include <algorithm>
#include <array>

#include <wm3d/core/parallel.hpp>

#include "closest_on_triangle.hpp"

namespace wm3d::metrics {

namespace {

constexpr std::size_t leaf_size = 4; // at most
constexpr std::size_t deepest = 64;  // the tree is balanced: never deeper than the bits of a count
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

} // namespace

TriangleBoxes::TriangleBoxes(const TriangleMesh& mesh, std::vector<Index> triangles)
    : mesh_(mesh), triangles_(std::move(triangles)), boxes_(nodes_for(triangles_.size())) {
    build(root(), centroids(mesh));
}

TriangleBoxes::Box TriangleBoxes::box_of(Index triangle) const {
    const NumberedTriangle t = numbered(mesh_, triangle);
    return {t.a.cwiseMin(t.b).cwiseMin(t.c), t.a.cwiseMax(t.b).cwiseMax(t.c)};
}

/// Half of the triangles on either side of the median, in the direction in which their centroids lie widest.
void TriangleBoxes::halve(const Branch& branch, const std::vector<Vec3>& centres) {
    const auto at = [&](std::size_t i) { return triangles_.begin() + static_cast<std::ptrdiff_t>(i); };
    const Vec3& first = centres[triangles_[branch.begin]];
    Box around{first, first};
    for (const Index f : triangles_of(branch))
        around.include({centres[f], centres[f]});
    Eigen::Index axis = 0;
    (around.max - around.min).maxCoeff(&axis);
    std::nth_element(at(branch.begin), at(branch.half()), at(branch.end), [&](Index s, Index t) {
        const double x = centres[s][axis], y = centres[t][axis];
        return x < y || (x == y && s < t);
    });
}

void TriangleBoxes::build(const Branch& branch, const std::vector<Vec3>& centres) {
    Box& box = boxes_[branch.node];
    if (is_leaf(branch)) {
        box = box_of(triangles_[branch.begin]);
        for (const Index f : triangles_of(branch).subspan(1))
            box.include(box_of(f));
        return;
    }
    halve(branch, centres);
    const auto left = [&] { build(branch.left(), centres); };
    const auto right = [&] { build(branch.right(), centres); };
    if (branch.end - branch.begin > worth_a_thread)
        parallel_invoke(left, right);
    else {
        left();
        right();
    }
    box = boxes_[branch.left().node];
    box.include(boxes_[branch.right().node]);
}

template<typename Wanted>
NearestTriangle TriangleBoxes::search(const Vec3& query, NearestTriangle known, Wanted&& wanted) const {
    struct Pending {
        Branch branch;
        double square; ///< of the distance to its box
    };
    const auto pending = [&](const Branch& branch) {
        return Pending{branch, boxes_[branch.node].squared_distance(query)};
    };
    std::array<Pending, deepest> stack;
    std::size_t size = 0;
    stack[size++] = pending(root());
    while (size > 0) {
        const auto [branch, square] = stack[--size];
        if (!known.may_yield_to(square))
            continue;
        if (is_leaf(branch)) {
            for (const Index f : triangles_of(branch))
                if (wanted(f))
                    known.improve(query, numbered(mesh_, f));
            continue;
        }
        Pending near = pending(branch.left()), far = pending(branch.right());
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

/// Triangles of the leaves whose boxes meet another box, or the first of them where they are more than `most`.
std::vector<Index> TriangleBoxes::meeting(const Box& box, std::size_t most) const {
    std::vector<Index> found;
    std::array<Branch, deepest> stack;
    std::size_t size = 0;
    stack[size++] = root();
    while (size > 0 && found.size() <= most) {
        const Branch branch = stack[--size];
        if (!boxes_[branch.node].meets(box))
            continue;
        if (is_leaf(branch)) {
            const std::span<const Index> leaf = triangles_of(branch);
            found.insert(found.end(), leaf.begin(), leaf.end());
            continue;
        }
        stack[size++] = branch.right();
        stack[size++] = branch.left();
    }
    return found;
}

double TriangleBoxes::clearance(Index vertex, double most) const {
    const NearestTriangle unknown{no_index, most * most};
    const auto other = [&](Index f) { return !has_corner(mesh_.triangles[f], vertex); };
    return std::sqrt(search(mesh_.positions[vertex], unknown, other).square);
}

/// Of one vertex from some triangles, those around it.
double TriangleBoxes::clearance(Index vertex, std::span<const Boxed> triangles, double most) const {
    const Vec3& p = mesh_.positions[vertex];
    double square = most * most;
    for (const auto& [box, f] : triangles) {
        if (!(box.squared_distance(p) < square) || has_corner(mesh_.triangles[f], vertex))
            continue;
        const NumberedTriangle t = numbered(mesh_, f);
        square = std::min(square, squared_distance_to_triangle(p, t.a, t.b, t.c));
    }
    return std::sqrt(square);
}

/// Of vertices that lie close together, so that they share one way down the tree, into `clearances`, #V.
void TriangleBoxes::clear(std::span<const Index> vertices, double most,
                          std::vector<double>& clearances) const {
    constexpr std::size_t most_around = 160; // where triangles are long, each vertex has its own way
    Box box{mesh_.positions[vertices[0]], mesh_.positions[vertices[0]]};
    for (const Index v : vertices)
        box.include({mesh_.positions[v], mesh_.positions[v]});
    box.min.array() -= most;
    box.max.array() += most;
    const std::vector<Index> found = meeting(box, most_around);
    std::vector<Boxed> around;
    if (found.size() <= most_around)
        for (const Index f : found)
            if (const Box own = box_of(f); own.meets(box))
                around.push_back({own, f});
    for (const Index v : vertices)
        clearances[v] = found.size() <= most_around ? clearance(v, around, most) : clearance(v, most);
}

std::vector<double> TriangleBoxes::clearances(double most) const {
    constexpr std::size_t group = 16; // triangles whose corners are looked at together
    constexpr std::size_t nowhere = std::numeric_limits<std::size_t>::max();
    std::vector<std::size_t> first(mesh_.positions.size(), nowhere); // place of a vertex's first triangle
    for (std::size_t i = triangles_.size(); i-- > 0;)
        for (const Index v : mesh_.triangles[triangles_[i]])
            first[v] = i;
    std::vector<double> clearances(mesh_.positions.size(), 0.0);
    parallel_blocks(triangles_.size(), 32 * group, [&](std::size_t begin, std::size_t end) {
        std::vector<Index> vertices;
        for (std::size_t i = begin; i < end; ++i) {
            for (const Index v : mesh_.triangles[triangles_[i]])
                if (first[v] == i && std::ranges::find(vertices, v) == vertices.end())
                    vertices.push_back(v);
            if (((i + 1) % group == 0 || i + 1 == end) && !vertices.empty()) {
                clear(vertices, most, clearances);
                vertices.clear();
            }
        }
    });
    return clearances;
}

} // namespace wm3d::metrics
