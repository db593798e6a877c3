// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/attack/resampling.hpp>

#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/Count_ratio_stop_predicate.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_cost.h>
#include <CGAL/Surface_mesh_simplification/Policies/Edge_collapse/LindstromTurk_placement.h>
#include <CGAL/Surface_mesh_simplification/edge_collapse.h>

#include "cgal_mesh.hpp"

namespace wm3d::attack {

TriangleMesh simplify_edges(const TriangleMesh& mesh, double percent) {
    namespace sms = CGAL::Surface_mesh_simplification;
    SurfaceMesh surface = to_cgal(mesh);
    return guarded("simplification", [&] {
        const sms::Count_ratio_stop_predicate<SurfaceMesh> stop(1 - percent / 100);
        sms::edge_collapse(surface, stop,
                           CGAL::parameters::get_cost(sms::LindstromTurk_cost<SurfaceMesh>())
                               .get_placement(sms::LindstromTurk_placement<SurfaceMesh>()));
        return from_cgal(surface);
    });
}

} // namespace wm3d::attack
