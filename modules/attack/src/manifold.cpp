// SPDX-License-Identifier: GPL-3.0-or-later
#include "manifold.hpp"

#include <algorithm>
#include <numeric>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Polygon_mesh_processing/orient_polygon_soup.h>

#include <wm3d/core/error.hpp>

namespace wm3d::attack {

namespace {

using Point = CGAL::Exact_predicates_inexact_constructions_kernel::Point_3;

/// Triangles with three different corners, the first of every set of three.
std::vector<Triangle> proper_triangles(const std::vector<Triangle>& triangles) {
    const auto sorted = [&](Index f) {
        Triangle t = triangles[f];
        std::sort(t.begin(), t.end());
        return t;
    };
    std::vector<std::pair<Triangle, Index>> order;
    order.reserve(triangles.size());
    for (Index f = 0; f < triangles.size(); ++f)
        order.emplace_back(sorted(f), f);
    std::sort(order.begin(), order.end());

    std::vector<char> keep(triangles.size(), 0);
    for (std::size_t i = 0; i < order.size(); ++i) {
        const Triangle& t = order[i].first;
        keep[order[i].second] = t[0] != t[1] && t[1] != t[2] && (i == 0 || t != order[i - 1].first);
    }
    std::vector<Triangle> proper;
    proper.reserve(triangles.size());
    for (std::size_t f = 0; f < triangles.size(); ++f)
        if (keep[f])
            proper.push_back(triangles[f]);
    return proper;
}

} // namespace

TriangleMesh without_unused_vertices(const TriangleMesh& mesh) {
    std::vector<Index> number(mesh.positions.size(), no_index);
    for (const Triangle& t : mesh.triangles)
        for (Index v : t)
            number[v] = 0;
    TriangleMesh used;
    for (std::size_t v = 0; v < number.size(); ++v)
        if (number[v] == 0) {
            number[v] = static_cast<Index>(used.positions.size());
            used.positions.push_back(mesh.positions[v]);
        }
    used.triangles.reserve(mesh.triangles.size());
    for (const Triangle& t : mesh.triangles)
        used.triangles.push_back({number[t[0]], number[t[1]], number[t[2]]});
    return used;
}

TriangleMesh make_manifold(const TriangleMesh& mesh) {
    const TriangleMesh used = without_unused_vertices({mesh.positions, proper_triangles(mesh.triangles)});
    if (used.triangles.empty())
        throw GeometryError(
            "the mesh has no triangle with three different corners, so there is no surface to "
            "work on; check that the file holds the model that you mean");
    std::vector<Point> points;
    points.reserve(used.positions.size());
    for (const Vec3& p : used.positions)
        points.emplace_back(p[0], p[1], p[2]);
    std::vector<std::vector<std::size_t>> polygons;
    polygons.reserve(used.triangles.size());
    for (const Triangle& t : used.triangles)
        polygons.emplace_back(t.begin(), t.end());

    CGAL::Polygon_mesh_processing::orient_polygon_soup(points, polygons);

    TriangleMesh manifold;
    manifold.positions.reserve(points.size());
    for (const Point& p : points)
        manifold.positions.emplace_back(p.x(), p.y(), p.z());
    manifold.triangles.reserve(polygons.size());
    for (const auto& polygon : polygons)
        manifold.triangles.push_back(
            {static_cast<Index>(polygon[0]), static_cast<Index>(polygon[1]), static_cast<Index>(polygon[2])});
    return manifold;
}

} // namespace wm3d::attack
