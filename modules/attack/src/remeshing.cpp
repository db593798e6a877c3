// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/attack/resampling.hpp>

#include <CGAL/Polygon_mesh_processing/remesh.h>

#include <wm3d/mesh/neighbours.hpp>

#include "cgal_mesh.hpp"

namespace wm3d::attack {

namespace {

double mean_edge_length(const TriangleMesh& mesh) {
    const std::vector<Edge> edges = edges_of(mesh);
    double sum = 0;
    for (const Edge& e : edges)
        sum += (mesh.positions[e.a] - mesh.positions[e.b]).norm();
    return sum / static_cast<double>(edges.size());
}

} // namespace

TriangleMesh remesh_isotropic(const TriangleMesh& mesh, const RemeshOptions& options) {
    SurfaceMesh surface = to_cgal(mesh);
    const double target = options.factor * mean_edge_length(mesh);
    if (!(target > 0))
        throw GeometryError("all edges of the mesh have length 0, so it can't be remeshed");
    return guarded("remeshing", [&] {
        CGAL::Polygon_mesh_processing::isotropic_remeshing(
            surface.faces(), target, surface,
            CGAL::parameters::number_of_iterations(static_cast<unsigned>(options.iterations)));
        return from_cgal(surface);
    });
}

} // namespace wm3d::attack
