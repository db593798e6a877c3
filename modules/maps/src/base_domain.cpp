// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/maps/base_domain.hpp>

#include <utility>

#include <wm3d/maps/equations.hpp>

#include "parameterizer.hpp"

namespace wm3d::maps {

namespace {

/// Base vertices lie at a corner of their first triangle.
void place_base_vertices(BaseDomain& domain) {
    for (std::size_t t = domain.mesh.triangles.size(); t-- > 0;)
        for (int k = 0; k < 3; ++k)
            domain.point[domain.original[domain.mesh.triangles[t][k]]] = {static_cast<Index>(t),
                                                                          Vec3::Unit(k)};
}

} // namespace

BaseDomain parameterize(const TriangleMesh& mesh, const simplify::Options& options,
                        const Progress& progress) {
    BaseDomain domain;
    Parameterizer parameterizer(mesh.positions.size(), domain);
    simplify::Result coarse = simplify::simplify(mesh, options, parameterizer, progress);
    domain.mesh = std::move(coarse.mesh);
    domain.original = std::move(coarse.original);
    domain.stop = coarse.stop;
    domain.error = coarse.error;
    domain.collapses = coarse.collapses;
    place_base_vertices(domain);
    return domain;
}

Vec3 image(const BaseDomain& domain, Index v) {
    const SurfacePoint& at = domain.point[v];
    const Triangle& t = domain.mesh.triangles[at.triangle];
    const auto& p = domain.mesh.positions;
    return base_point({p[t[0]], p[t[1]], p[t[2]]}, at.barycentric);
}

} // namespace wm3d::maps
