// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/maps/base_domain.hpp>

#include <doctest/doctest.h>
#include <wm3d/maps.hpp>
#include <wm3d/shapes.hpp>

using namespace wm3d;

TEST_CASE("a flat mesh is parameterized by itself") {
    const TriangleMesh mesh = shapes::square(1, 20);
    const auto domain = maps::parameterize(mesh, {.target_vertices = 60});
    for (Index v = 0; v < mesh.positions.size(); ++v)
        CHECK((maps::image(domain, v) - mesh.positions[v]).norm() < 1e-9);
}
