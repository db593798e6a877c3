// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  To CGAL's surface mesh and back; only for the units that call CGAL.
#pragma once

#include <string>

#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Surface_mesh.h>

#include <wm3d/core/error.hpp>
#include <wm3d/mesh/triangle_mesh.hpp>

#include "manifold.hpp"

namespace wm3d::attack {

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using SurfaceMesh = CGAL::Surface_mesh<Kernel::Point_3>;

/// CGAL's mesh of the manifold that `make_manifold` makes of the input.
inline SurfaceMesh to_cgal(const TriangleMesh& mesh) {
    const TriangleMesh manifold = make_manifold(mesh);
    SurfaceMesh surface;
    surface.reserve(static_cast<SurfaceMesh::size_type>(manifold.positions.size()),
                    static_cast<SurfaceMesh::size_type>(3 * manifold.triangles.size() / 2),
                    static_cast<SurfaceMesh::size_type>(manifold.triangles.size()));
    for (const Vec3& p : manifold.positions)
        surface.add_vertex({p[0], p[1], p[2]});
    using Vertex = SurfaceMesh::Vertex_index;
    for (const Triangle& t : manifold.triangles)
        if (surface.add_face(Vertex(t[0]), Vertex(t[1]), Vertex(t[2])) == SurfaceMesh::null_face())
            throw GeometryError(
                "the triangles around vertex " + std::to_string(t[0]) +
                " do not form a surface even after repair; repair the model in a mesh editor");
    return surface;
}

inline TriangleMesh from_cgal(SurfaceMesh& surface) {
    surface.collect_garbage();
    TriangleMesh mesh;
    mesh.positions.reserve(surface.number_of_vertices());
    for (const auto v : surface.vertices()) {
        const auto& p = surface.point(v);
        mesh.positions.emplace_back(p.x(), p.y(), p.z());
    }
    mesh.triangles.reserve(surface.number_of_faces());
    for (const auto f : surface.faces()) {
        Triangle t{};
        std::size_t k = 0;
        for (const auto v : CGAL::vertices_around_face(surface.halfedge(f), surface))
            t[k++] = static_cast<Index>(v);
        mesh.triangles.push_back(t);
    }
    return mesh;
}

/// Runs `work`, turning CGAL's own failures into a sentence.
template<typename Work>
auto guarded(const char* what, Work&& work) {
    try {
        return work();
    } catch (const CGAL::Failure_exception& failure) {
        throw GeometryError(std::string(what) + " could not work on this mesh (CGAL: " + failure.message() +
                            "); repair self-intersections and degenerate triangles first");
    }
}

} // namespace wm3d::attack
