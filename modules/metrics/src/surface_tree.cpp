// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/metrics/surface_tree.hpp>

#include <algorithm>
#include <cmath>
#include <mutex>
#include <optional>
#include <vector>

#include <wm3d/core/error.hpp>
#include <wm3d/core/parallel.hpp>
#include <wm3d/mesh/measure.hpp>

#include "closest_on_triangle.hpp"
#include "triangle_boxes.hpp"

namespace wm3d::metrics {

struct SurfaceTree::Boxes {
    std::once_flag made;
    std::optional<TriangleBoxes> tree;
};

SurfaceTree::SurfaceTree(const TriangleMesh& mesh, Made made)
    : mesh_(&mesh), has_area_(mesh.triangles.size()), boxes_(std::make_unique<Boxes>()) {
    for (std::size_t f = 0; f < has_area_.size(); ++f)
        has_area_[f] = area_vector(mesh, f).squaredNorm() > 0;
    if (std::ranges::count(has_area_, 1) == 0)
        throw GeometryError(
            "the mesh has no triangle with an area, so no distance to it can be measured; check "
            "that the file holds the model that you mean");
    if (made == Made::at_once)
        boxes();
}

std::vector<Index> SurfaceTree::with_area() const {
    std::vector<Index> triangles;
    triangles.reserve(has_area_.size());
    for (Index f = 0; f < has_area_.size(); ++f)
        if (has_area(f))
            triangles.push_back(f);
    return triangles;
}

const TriangleBoxes& SurfaceTree::boxes() const {
    std::call_once(boxes_->made, [this] {
        // As a task of its own, which takes no other meanwhile that may ask for the same.
        parallel_tasks(1, [this](std::size_t) { boxes_->tree.emplace(*mesh_, with_area()); });
    });
    return *boxes_->tree;
}

SurfaceTree::~SurfaceTree() = default;
SurfaceTree::SurfaceTree(SurfaceTree&&) noexcept = default;
SurfaceTree& SurfaceTree::operator=(SurfaceTree&&) noexcept = default;

ClosestPoint SurfaceTree::closest(const Vec3& query) const {
    return on(boxes().nearest(query).triangle, query);
}

ClosestPoint SurfaceTree::closest(const Vec3& query, Index near) const {
    NearestTriangle known;
    if (has_area(near))
        known.improve(query, numbered(*mesh_, near));
    return on(boxes().nearest(query, known).triangle, query);
}

ClosestPoint SurfaceTree::closest(const Vec3& query, Index known, Index of) const {
    if (!has_area(of))
        return closest(query);
    const double bound = (mesh_->positions[known] - query).squaredNorm();
    return on(boxes().nearest(query, {of, bound}).triangle, query);
}

ClosestPoint SurfaceTree::closest_of(std::span<const Index> triangles, const Vec3& query) const {
    NearestTriangle best;
    for (Index f : triangles)
        if (has_area(f))
            best.improve(query, numbered(*mesh_, f));
    return on(best.triangle, query);
}

std::vector<double> SurfaceTree::clearances(double most) const {
    return boxes().clearances(most);
}

ClosestPoint SurfaceTree::on(Index triangle, const Vec3& query) const {
    const Triangle& t = mesh_->triangles[triangle];
    ClosestPoint closest;
    closest.at.triangle = triangle;
    closest.at.barycentric =
        closest_on_triangle(query, mesh_->positions[t[0]], mesh_->positions[t[1]], mesh_->positions[t[2]]);
    closest.position = evaluate(*mesh_, closest.at);
    closest.distance = (closest.position - query).norm();
    return closest;
}

} // namespace wm3d::metrics
