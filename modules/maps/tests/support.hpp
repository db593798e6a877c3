// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  What the tests of the parameterization share.
#pragma once

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>
#include <wm3d/maps.hpp>
#include <wm3d/mesh.hpp>

namespace wm3d::maps::test {

/// What is promised of every base domain: places with coordinates, base vertices at their corners.
inline void check_domain(const TriangleMesh& mesh, const BaseDomain& domain) {
    REQUIRE(domain.point.size() == mesh.positions.size());
    std::vector<bool> used(mesh.positions.size(), false);
    for (const Triangle& t : mesh.triangles)
        if (t[0] != t[1] && t[1] != t[2] && t[2] != t[0])
            for (Index v : t)
                used[v] = true;
    std::size_t wrong = 0;
    for (std::size_t v = 0; v < domain.point.size(); ++v) {
        const SurfacePoint& p = domain.point[v];
        if (!used[v])
            wrong += p.triangle != no_index;
        else
            wrong += p.triangle >= domain.mesh.triangles.size() || !(p.barycentric.minCoeff() >= 0) ||
                     !(std::abs(p.barycentric.sum() - 1) <= 1e-12);
    }
    CHECK(wrong == 0);
    for (Index b = 0; b < domain.original.size(); ++b) {
        const SurfacePoint& p = domain.point[domain.original[b]];
        REQUIRE(p.barycentric.maxCoeff() == 1);
        Eigen::Index corner = 0;
        p.barycentric.maxCoeff(&corner);
        CHECK(domain.mesh.triangles[p.triangle][static_cast<std::size_t>(corner)] == b);
        CHECK(image(domain, domain.original[b]) == mesh.positions[domain.original[b]]);
    }
}

/// Vertices that have a place and that Pi^-1 doesn't bring back to within `tolerance` box diagonals.
inline std::size_t not_returned(const TriangleMesh& mesh, const BaseDomain& domain, double tolerance) {
    const InverseMap inverse(mesh, domain);
    const double size = surface_box(mesh).diagonal();
    std::size_t count = inverse.left_out();
    for (std::size_t v = 0; v < domain.point.size(); ++v)
        if (domain.point[v].triangle != no_index)
            count += (inverse.to_surface(domain.point[v]) - mesh.positions[v]).norm() > tolerance * size;
    return count;
}

} // namespace wm3d::maps::test
