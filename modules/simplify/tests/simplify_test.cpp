// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/simplify/simplify.hpp>

#include <cmath>
#include <string>

#include <doctest/doctest.h>
#include <wm3d/core/error.hpp>
#include <wm3d/shapes.hpp>

#include "support.hpp"

using namespace wm3d;
using namespace wm3d::simplify;
using namespace wm3d::simplify::test;

TEST_CASE("base vertices are vertices of the input at their own positions") {
    const TriangleMesh mesh = shapes::blob(3000, 5);
    const Result result = simplify::simplify(mesh, {.target_vertices = 400});
    REQUIRE(result.stop == Stop::reached);
    REQUIRE(result.original.size() == 400);
    REQUIRE(result.mesh.positions.size() == 400);
    CHECK(result.collapses == mesh.positions.size() - 400);
    std::vector<Index> numbers = result.original;
    std::sort(numbers.begin(), numbers.end());
    CHECK(std::adjacent_find(numbers.begin(), numbers.end()) == numbers.end());
    for (std::size_t i = 0; i < result.original.size(); ++i)
        CHECK(result.mesh.positions[i] == mesh.positions[result.original[i]]);
}

TEST_CASE("every number of vertices is reached exactly, down to a tetrahedron") {
    const TriangleMesh mesh = shapes::sphere(1, 12);
    for (std::size_t target = mesh.positions.size() - 1; target >= 4; target -= 1 + target / 7) {
        const Result result = simplify::simplify(mesh, {.target_vertices = target});
        CHECK(result.stop == Stop::reached);
        CHECK(result.mesh.positions.size() == target);
        CHECK(result.mesh.triangles.size() == 2 * target - 4);
    }
}

TEST_CASE("a target that can't be met stops with its reason") {
    const TriangleMesh sphere = shapes::sphere(1, 8);
    for (std::size_t target : {0u, 1u, 3u}) {
        const Result result = simplify::simplify(sphere, {.target_vertices = target});
        CHECK(result.stop == Stop::blocked);
        CHECK(result.mesh.positions.size() >= 4);
        CHECK(inspect_topology(result.mesh).closed());
    }
    const Result same = simplify::simplify(sphere, {.target_vertices = 1000});
    CHECK(same.stop == Stop::already_small);
    CHECK(same.collapses == 0);
    CHECK(same.error == 0);
    CHECK(same.mesh.positions.size() == sphere.positions.size());
    CHECK(same.mesh.triangles.size() == sphere.triangles.size());
    for (Stop stop : {Stop::reached, Stop::already_small, Stop::blocked})
        CHECK(!describe(stop).empty());
}

TEST_CASE("flat regions go first and creases stay") {
    const TriangleMesh box = shapes::box({1, 2, 3}, 10);
    const Result result = simplify::simplify(box, {.target_vertices = 8});
    REQUIRE(result.stop == Stop::reached);
    for (const Vec3& p : result.mesh.positions)
        for (int k = 0; k < 3; ++k)
            CHECK((p[k] == 0 || p[k] == k + 1));
    CHECK(enclosed_volume(result.mesh) == doctest::Approx(6).epsilon(1e-12));
    CHECK(result.error < 0.02); // the isotropic part alone
}

TEST_CASE("a sphere stays near the sphere and faces outwards") {
    const Result result = simplify::simplify(shapes::sphere(1, 60), {.target_vertices = 500});
    CHECK(enclosed_volume(result.mesh) > 0.97 * 4.18879);
    for (std::size_t f = 0; f < result.mesh.triangles.size(); ++f) {
        const Triangle& t = result.mesh.triangles[f];
        const Vec3 centre =
            (result.mesh.positions[t[0]] + result.mesh.positions[t[1]] + result.mesh.positions[t[2]]) / 3;
        CHECK(area_vector(result.mesh, f).dot(centre) > 0);
    }
}

TEST_CASE("the reported error is the size of what was lost") {
    const TriangleMesh mesh = shapes::sphere(10, 60);
    const Result coarse = simplify::simplify(mesh, {.target_vertices = 100});
    const Result fine = simplify::simplify(mesh, {.target_vertices = 2000});
    CHECK(fine.error > 0);
    CHECK(fine.error < coarse.error);
    CHECK(coarse.error < 1.5); // sagitta of a cap of a hundredth of the sphere: 0.2
}

TEST_CASE("options out of range are refused") {
    const TriangleMesh mesh = shapes::sphere(1, 4);
    CHECK_THROWS_AS(simplify::simplify(mesh, {.boundary_weight = -1}), ParameterError);
    CHECK_THROWS_AS(simplify::simplify(mesh, {.boundary_weight = NAN}), ParameterError);
    CHECK_THROWS_AS(simplify::simplify(mesh, {.isotropy = INFINITY}), ParameterError);
    CHECK_THROWS_AS(simplify::simplify(mesh, {.max_normal_turn = 91}), ParameterError);
}

TEST_CASE("progress begins at 0, never falls and ends at 1") {
    std::vector<double> seen;
    simplify::simplify(shapes::blob(20000, 1), {.target_vertices = 500},
                       [&](std::string_view, double done) { seen.push_back(done); });
    REQUIRE(seen.size() > 2);
    CHECK(seen.front() == 0);
    CHECK(seen.back() == 1);
    CHECK(std::is_sorted(seen.begin(), seen.end()));
}
