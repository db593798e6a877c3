// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/attack/cropping.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <doctest/doctest.h>
#include <wm3d/core/error.hpp>
#include <wm3d/shapes.hpp>

#include "meshes.hpp"

using namespace wm3d;
using namespace wm3d::attack;
using namespace wm3d::attack::test;

TEST_CASE("the cut removes the wanted share of the vertices") {
    const TriangleMesh mesh = shapes::blob(5000, 6);
    for (double percent : {10.0, 30.0, 50.0, 99.0})
        for (std::uint64_t seed : {1, 2, 3}) {
            const TriangleMesh part = crop(mesh, {percent, {}, false}, seed);
            std::size_t kept = 0;
            for (const Vec3& p : part.positions)
                kept += std::find(mesh.positions.begin(), mesh.positions.end(), p) != mesh.positions.end();
            const double removed =
                100 - 100 * static_cast<double>(kept) / static_cast<double>(mesh.positions.size());
            CHECK(std::abs(removed - percent) < 0.1);
        }
}

TEST_CASE("an open cut leaves a border and the surface of its side, a closed cut leaves none") {
    const TriangleMesh box = shapes::box({1, 1, 2}, 9);
    // 9 cells along z: the plane falls in the middle of one
    const TriangleMesh open = crop(box, {50, Vec3(0, 0, 1), false}, 0);
    const TriangleMesh closed = crop(box, {50, Vec3(0, 0, 1), true}, 0);
    CHECK(inspect_topology(open).boundary_edges > 0);
    CHECK(inspect_topology(closed).boundary_edges == 0);
    CHECK(is_manifold(closed));
    CHECK(inspect_topology(closed).euler_characteristic == 2);
    CHECK(closed.positions.size() == open.positions.size());
    const double height = bounding_box(open.positions).max[2];
    CHECK(surface_area(open) == doctest::Approx(1 + 4 * height));
    CHECK(surface_area(closed) == doctest::Approx(2 + 4 * height));
    CHECK(enclosed_volume(closed) == doctest::Approx(height));
}

TEST_CASE("a cap leaves out the hole of a tube") {
    const TriangleMesh torus = shapes::torus(2, 0.5, 60, 40);
    const TriangleMesh lying = crop(torus, {50, Vec3(0.001, 0.002, 1), true}, 0); // the cut is a ring
    CHECK(inspect_topology(lying).boundary_edges == 0);
    CHECK(enclosed_volume(lying) == doctest::Approx(enclosed_volume(torus) / 2).epsilon(0.1));
    const TriangleMesh standing = crop(torus, {50, Vec3(1, 0.001, 0.002), true}, 0); // two discs
    CHECK(inspect_topology(standing).boundary_edges == 0);
    CHECK(inspect_topology(standing).euler_characteristic == 2);
    CHECK(enclosed_volume(standing) == doctest::Approx(enclosed_volume(torus) / 2).epsilon(0.01));
}

TEST_CASE("what can't be cut is refused") {
    const TriangleMesh flat = shapes::square(1, 3);
    CHECK_THROWS_AS(crop(flat, {30, Vec3(0, 0, 1), false}, 0), GeometryError);
    CHECK_THROWS_AS(crop(flat, {0, {}, false}, 0), ParameterError);
    CHECK_THROWS_AS(crop(flat, {30, Vec3(0, 0, 0), false}, 0), ParameterError);
}

TEST_CASE("vertices that lie in the plane do not make flat triangles") {
    const TriangleMesh part = crop(shapes::box({1, 1, 1}, 4), {50, Vec3(1, 0, 0), false}, 0);
    for (std::size_t f = 0; f < part.triangles.size(); ++f)
        CHECK(area_vector(part, f).norm() > 1e-6);
}
