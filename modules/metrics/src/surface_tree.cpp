// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/metrics/surface_tree.hpp>

#include <vector>

#include <wm3d/core/error.hpp>
#include <wm3d/mesh/measure.hpp>

#include "closest_on_triangle.hpp"
#include "triangle_boxes.hpp"

namespace wm3d::metrics {

SurfaceTree::SurfaceTree(const TriangleMesh& mesh) : mesh_(&mesh) {
    std::vector<TriangleBoxes::Corners> triangles;
    triangles.reserve(mesh.triangles.size());
    for (Index f = 0; f < mesh.triangles.size(); ++f) {
        const Triangle& t = mesh.triangles[f];
        if (area_vector(mesh, f).norm() > 0)
            triangles.push_back({mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]], f});
    }
    if (triangles.empty())
        throw GeometryError(
            "the mesh has no triangle with an area, so no distance to it can be measured; check "
            "that the file holds the model that you mean");
    boxes_ = std::make_unique<TriangleBoxes>(std::move(triangles));
}

SurfaceTree::~SurfaceTree() = default;
SurfaceTree::SurfaceTree(SurfaceTree&&) noexcept = default;
SurfaceTree& SurfaceTree::operator=(SurfaceTree&&) noexcept = default;

ClosestPoint SurfaceTree::closest(const Vec3& query) const {
    return closest(query, {});
}

ClosestPoint SurfaceTree::closest(const Vec3& query, std::span<const Index> likely) const {
    const auto corner = [&](Index f, std::size_t k) -> const Vec3& {
        return mesh_->positions[mesh_->triangles[f][k]];
    };
    NearestTriangle known;
    for (Index f : likely)
        if (area_vector(*mesh_, f).norm() > 0)
            improve(known, f, squared_distance_to_triangle(query, corner(f, 0), corner(f, 1), corner(f, 2)));
    ClosestPoint closest;
    const Index f = closest.at.triangle = boxes_->nearest(query, known).triangle;
    closest.at.barycentric = closest_on_triangle(query, corner(f, 0), corner(f, 1), corner(f, 2));
    closest.position = evaluate(*mesh_, closest.at);
    closest.distance = (closest.position - query).norm();
    return closest;
}

} // namespace wm3d::metrics
