// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/shapes/contour.hpp>

#include <cmath>
#include <numbers>

#include <doctest/doctest.h>
#include <wm3d/core/error.hpp>
#include <wm3d/core/parallel.hpp>
#include <wm3d/mesh.hpp>

using namespace wm3d;
using shapes::contour;

namespace {

const Box around{Vec3::Constant(-1.53), Vec3::Constant(1.57)};

double sphere_solid(const Vec3& p) {
    return p.norm() - 1;
}

double cube_solid(const Vec3& p) {
    const Vec3 q = p.cwiseAbs() - Vec3::Constant(1);
    return q.cwiseMax(0.0).norm() + std::min(q.maxCoeff(), 0.0);
}

} // namespace

TEST_CASE("the contour of a ball is a closed sphere") {
    const TriangleMesh mesh = contour(sphere_solid, around, {.cell = 0.05});
    const Topology t = inspect_topology(mesh);
    CHECK(t.euler_characteristic == 2);
    CHECK(t.closed());
    CHECK(enclosed_volume(mesh) == doctest::Approx(4 * std::numbers::pi / 3).epsilon(2e-3));
    for (const Vec3& p : mesh.positions)
        CHECK(p.norm() == doctest::Approx(1).epsilon(1e-3));
}

TEST_CASE("edges and corners of a cube stay sharp") {
    const TriangleMesh mesh = contour(cube_solid, around, {.cell = 0.1});
    CHECK(enclosed_volume(mesh) == doctest::Approx(8).epsilon(1e-6));
    CHECK(surface_area(mesh) == doctest::Approx(24).epsilon(1e-6));
    const Box box = bounding_box(mesh.positions);
    CHECK(box.min.isApprox(Vec3::Constant(-1), 1e-6));
    CHECK(box.max.isApprox(Vec3::Constant(1), 1e-6));
}

TEST_CASE("two sheets in one cube get a vertex each") {
    // Two balls a fifth of a cell apart.
    const auto solid = [](const Vec3& p) {
        return std::min((p - Vec3(0.51, 0, 0)).norm(), (p + Vec3(0.51, 0, 0)).norm()) - 0.5;
    };
    const TriangleMesh mesh = contour(solid, around, {.cell = 0.1});
    CHECK(inspect_topology(mesh).closed());
}

TEST_CASE("the bytes don't depend on the number of threads") {
    const auto at = [](std::size_t threads) {
        const ThreadLimit limit(threads);
        return contour(sphere_solid, around, {.cell = 0.07}).positions;
    };
    CHECK(at(1) == at(2));
}

TEST_CASE("senseless cells are refused") {
    CHECK_THROWS_AS(contour(sphere_solid, around, {.cell = 0}), ParameterError);
    CHECK_THROWS_AS(contour(sphere_solid, around, {.cell = 1e-6}), ParameterError);
    CHECK_THROWS_AS(contour(sphere_solid, around, {.cell = std::nan("")}), ParameterError);
}
