// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/metrics/surface_tree.hpp>

#include <vector>

#include <CGAL/AABB_traits.h>
#include <CGAL/AABB_tree.h>
#include <CGAL/AABB_triangle_primitive.h>
#include <CGAL/Simple_cartesian.h>

#include <wm3d/core/error.hpp>
#include <wm3d/mesh/measure.hpp>

#include "closest_on_triangle.hpp"

namespace wm3d::metrics {

// Plain doubles: a query only chooses a triangle, the point on it is computed afterwards.
using Kernel = CGAL::Simple_cartesian<double>;
using Facets = std::vector<Kernel::Triangle_3>;
using Primitive = CGAL::AABB_triangle_primitive<Kernel, Facets::const_iterator>;
using Boxes = CGAL::AABB_tree<CGAL::AABB_traits<Kernel, Primitive>>;

struct SurfaceTree::Tree {
    Facets facets;
    std::vector<Index> triangle_of; ///< #facets
    Boxes boxes;
};

SurfaceTree::SurfaceTree(const TriangleMesh& mesh) : mesh_(&mesh), tree_(std::make_unique<Tree>()) {
    const auto point = [&](Index v) {
        const Vec3& p = mesh.positions[v];
        return Kernel::Point_3(p[0], p[1], p[2]);
    };
    tree_->facets.reserve(mesh.triangles.size());
    for (Index f = 0; f < mesh.triangles.size(); ++f) {
        const Triangle& t = mesh.triangles[f];
        if (!(area_vector(mesh, f).norm() > 0))
            continue;
        tree_->facets.emplace_back(point(t[0]), point(t[1]), point(t[2]));
        tree_->triangle_of.push_back(f);
    }
    if (tree_->facets.empty())
        throw GeometryError(
            "the mesh has no triangle with an area, so no distance to it can be measured; check "
            "that the file holds the model that you mean");
    tree_->boxes.insert(tree_->facets.cbegin(), tree_->facets.cend());
    tree_->boxes.build();
    tree_->boxes.accelerate_distance_queries(); // now, since queries may come from several threads
}

SurfaceTree::~SurfaceTree() = default;
SurfaceTree::SurfaceTree(SurfaceTree&&) noexcept = default;
SurfaceTree& SurfaceTree::operator=(SurfaceTree&&) noexcept = default;

ClosestPoint SurfaceTree::closest(const Vec3& query) const {
    const auto found = tree_->boxes.closest_point_and_primitive({query[0], query[1], query[2]});
    ClosestPoint closest;
    closest.at.triangle = tree_->triangle_of[static_cast<std::size_t>(found.second - tree_->facets.cbegin())];
    const Triangle& t = mesh_->triangles[closest.at.triangle];
    closest.at.barycentric =
        closest_on_triangle(query, mesh_->positions[t[0]], mesh_->positions[t[1]], mesh_->positions[t[2]]);
    closest.position = evaluate(*mesh_, closest.at);
    closest.distance = (closest.position - query).norm();
    return closest;
}

} // namespace wm3d::metrics
