// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/attack/flips.hpp>

#include <cmath>

#include <doctest/doctest.h>
#include <wm3d/shapes.hpp>

#include "../src/flipper.hpp"
#include "meshes.hpp"

using namespace wm3d;
using namespace wm3d::attack;
using namespace wm3d::attack::test;

TEST_CASE("random flips keep vertices, Euler number, orientation and border") {
    for (const TriangleMesh& mesh :
         {shapes::blob(3000, 2), shapes::torus(2, 0.6, 60, 30), shapes::square(1, 20)}) {
        const Flipped flipped = flip_random(mesh, 30, 5);
        CHECK(flipped.mesh.positions == mesh.positions);
        CHECK(flipped.mesh.triangles.size() == mesh.triangles.size());
        CHECK(flipped.mesh.triangles != mesh.triangles);
        const Topology before = inspect_topology(mesh), after = inspect_topology(flipped.mesh);
        CHECK(after.euler_characteristic == before.euler_characteristic);
        CHECK(after.boundary_edges == before.boundary_edges);
        CHECK(is_manifold(flipped.mesh));
        CHECK(std::abs(static_cast<double>(flipped.flips) - 0.3 * static_cast<double>(before.edges)) <= 1);
        CHECK(surface_area(flipped.mesh) == doctest::Approx(surface_area(mesh)).epsilon(0.01));
    }
}

TEST_CASE("creases are not flipped") {
    const TriangleMesh box = shapes::box({1, 2, 3}, 4);
    const Flipped flipped = flip_random(box, 100, 1);
    CHECK(flipped.flips > 0);
    CHECK(surface_area(flipped.mesh) == doctest::Approx(22).epsilon(1e-12));
    CHECK(enclosed_volume(flipped.mesh) == doctest::Approx(6).epsilon(1e-12));
}

TEST_CASE("Delaunay flips leave no edge with opposite angles of more than 180 degrees on a plane") {
    const TriangleMesh mesh = flip_random(shapes::square(1, 12), 60, 3).mesh;
    const auto bad_edges = [](const TriangleMesh& m) {
        const Flipper flipper(m, 20);
        std::size_t bad = 0;
        for (Index edge : flipper.inner_edges())
            bad += !flipper.is_delaunay(edge);
        return bad;
    };
    CHECK(bad_edges(mesh) > 0);
    const Flipped delaunay = flip_delaunay(mesh);
    CHECK(delaunay.flips > 0);
    CHECK(bad_edges(delaunay.mesh) == 0);
    CHECK(inspect_topology(delaunay.mesh).euler_characteristic == 1);
    CHECK(surface_area(delaunay.mesh) == doctest::Approx(1).epsilon(1e-12));
}

TEST_CASE("edges with three triangles and neighbours turned over stay") {
    CHECK(flip_random(hostile(), 100, 1).mesh.triangles.size() == hostile().triangles.size());
}
