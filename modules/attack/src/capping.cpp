// SPDX-License-Identifier: GPL-3.0-or-later
#include "capping.hpp"

#include <deque>
#include <map>

#include <CGAL/Constrained_Delaunay_triangulation_2.h>
#include <CGAL/Constrained_triangulation_face_base_2.h>
#include <CGAL/Exact_predicates_inexact_constructions_kernel.h>
#include <CGAL/Triangulation_face_base_with_info_2.h>
#include <CGAL/Triangulation_vertex_base_with_info_2.h>

#include <wm3d/core/error.hpp>

namespace wm3d::attack {

namespace {

constexpr int unseen = -1;

using Kernel = CGAL::Exact_predicates_inexact_constructions_kernel;
using VertexBase = CGAL::Triangulation_vertex_base_with_info_2<Index, Kernel>;
using FaceBase =
    CGAL::Triangulation_face_base_with_info_2<int, Kernel,
                                              CGAL::Constrained_triangulation_face_base_2<Kernel>>;
using Triangulation =
    CGAL::Constrained_Delaunay_triangulation_2<Kernel,
                                               CGAL::Triangulation_data_structure_2<VertexBase, FaceBase>,
                                               CGAL::No_constraint_intersection_requiring_constructions_tag>;

/// Counts into every face's info how many constraints lie between it and the outside.
void mark_depths(Triangulation& triangulation) {
    for (auto face : triangulation.all_face_handles())
        face->info() = unseen;
    std::deque<Triangulation::Face_handle> queue{triangulation.infinite_face()};
    queue.front()->info() = 0;
    // Faces of the same depth are finished before those behind a constraint.
    while (!queue.empty()) {
        const auto face = queue.front();
        queue.pop_front();
        for (int k = 0; k < 3; ++k) {
            const auto neighbour = face->neighbor(k);
            if (neighbour->info() != unseen)
                continue;
            const bool crosses = face->is_constrained(k);
            neighbour->info() = face->info() + (crosses ? 1 : 0);
            if (crosses)
                queue.push_back(neighbour);
            else
                queue.push_front(neighbour);
        }
    }
}

} // namespace

void cap(TriangleMesh& mesh, const std::vector<std::array<Index, 2>>& outline, const Vec3& normal) {
    const Vec3 u = normal.unitOrthogonal(), v = normal.cross(u); // (u, v, normal) is right-handed
    Triangulation triangulation;
    std::map<Index, Triangulation::Vertex_handle> handles;
    const auto insert = [&](Index vertex) {
        const auto [at, is_new] = handles.try_emplace(vertex);
        if (is_new) {
            const Vec3& p = mesh.positions[vertex];
            const auto known = triangulation.number_of_vertices();
            at->second = triangulation.insert({u.dot(p), v.dot(p)});
            if (triangulation.number_of_vertices() > known) // else it coincides with an earlier vertex
                at->second->info() = vertex;
        }
        return at->second;
    };
    try {
        for (const auto& [from, to] : outline) {
            const auto a = insert(from), b = insert(to);
            if (a != b)
                triangulation.insert_constraint(a, b);
        }
    } catch (const Triangulation::Intersection_of_constraints_exception&) {
        throw GeometryError(
            "the outline of the cut crosses itself because the surface does, so the cut can't be "
            "closed; leave it open, or cut elsewhere");
    }
    mark_depths(triangulation);
    for (auto face : triangulation.finite_face_handles())
        if (face->info() % 2 == 1)
            mesh.triangles.push_back(
                {face->vertex(0)->info(), face->vertex(1)->info(), face->vertex(2)->info()});
}

} // namespace wm3d::attack
