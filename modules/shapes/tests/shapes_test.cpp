// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/shapes.hpp>

#include <numbers>
#include <utility>

#include <doctest/doctest.h>
#include <wm3d/mesh.hpp>

using namespace wm3d;

TEST_CASE("closed shapes are closed, oriented outwards and have their genus") {
    const std::vector<std::pair<TriangleMesh, long>> shapes_and_euler{{shapes::box({1, 2, 3}, 4), 2},
                                                                      {shapes::sphere(2, 9), 2},
                                                                      {shapes::ellipsoid({3, 2, 1}, 7), 2},
                                                                      {shapes::torus(3, 1, 12, 8), 0},
                                                                      {shapes::blob(3000, 7), 2}};
    for (const auto& [mesh, euler] : shapes_and_euler) {
        const Topology t = inspect_topology(mesh);
        CHECK(t.euler_characteristic == euler);
        CHECK(t.closed());
        CHECK(enclosed_volume(mesh) > 0);
    }
}

TEST_CASE("a square has one boundary loop and its area") {
    const TriangleMesh mesh = shapes::square(2.0, 5);
    const Topology t = inspect_topology(mesh);
    CHECK(t.euler_characteristic == 1);
    CHECK(t.boundary_edges == 20);
    CHECK(t.boundary_loops == 1);
    CHECK(surface_area(mesh) == doctest::Approx(4.0).epsilon(1e-14));
}

TEST_CASE("areas approach the formula as the mesh gets finer") {
    CHECK(surface_area(shapes::sphere(1, 200)) == doctest::Approx(4 * std::numbers::pi).epsilon(1e-3));
    CHECK(surface_area(shapes::torus(2, 0.5, 400, 200)) ==
          doctest::Approx(4 * std::numbers::pi * std::numbers::pi).epsilon(1e-3));
    CHECK(surface_area(shapes::box({1, 2, 3}, 3)) == doctest::Approx(22.0).epsilon(1e-14));
}

TEST_CASE("a blob repeats with its seed and changes with it") {
    CHECK(shapes::blob(500, 1).positions == shapes::blob(500, 1).positions);
    CHECK(shapes::blob(500, 1).positions != shapes::blob(500, 2).positions);
}
