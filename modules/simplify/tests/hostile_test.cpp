// SPDX-License-Identifier: GPL-3.0-or-later
// Meshes as they are found.
#include <cmath>
#include <string>

#include <doctest/doctest.h>
#include <wm3d/core/error.hpp>
#include <wm3d/shapes.hpp>

#include "support.hpp"

using namespace wm3d;
using namespace wm3d::simplify;
using namespace wm3d::simplify::test;

TEST_CASE("nothing in, nothing out") {
    const Result empty = simplify::simplify({}, {.target_vertices = 10});
    CHECK(empty.stop == Stop::already_small);
    CHECK(empty.mesh.positions.empty());
    const TriangleMesh cloud{{{0, 0, 0}, {1, 2, 3}}, {}};
    CHECK(simplify::simplify(cloud, {}).mesh.positions.empty());
}

TEST_CASE("isolated vertices and repeated or degenerate triangles change nothing") {
    const TriangleMesh clean = shapes::blob(1500, 11);
    const Result expected = simplify::simplify(clean, {.target_vertices = 200});
    TriangleMesh mesh = clean;
    mesh.positions.push_back({100, 100, 100});
    for (std::size_t f = 0; f < clean.triangles.size(); f += 7) {
        const Triangle t = clean.triangles[f];
        mesh.triangles.push_back({t[1], t[2], t[0]});
        mesh.triangles.push_back({t[0], t[0], t[1]});
        mesh.triangles.push_back(t);
    }
    const Result result = simplify::simplify(mesh, {.target_vertices = 200});
    CHECK(result.original == expected.original);
    CHECK(result.mesh.triangles == expected.mesh.triangles);
}

TEST_CASE("triangles that face the wrong way are turned, the larger area deciding") {
    const TriangleMesh clean = shapes::blob(1500, 12);
    TriangleMesh mesh = clean;
    for (std::size_t f = 0; f < mesh.triangles.size(); f += 3)
        std::swap(mesh.triangles[f][0], mesh.triangles[f][1]);
    const Result expected = simplify::simplify(clean, {.target_vertices = 200});
    const Result result = simplify::simplify(mesh, {.target_vertices = 200});
    CHECK(result.original == expected.original);
    CHECK(inspect_topology(result.mesh).closed());
    CHECK(enclosed_volume(result.mesh) == doctest::Approx(enclosed_volume(expected.mesh)).epsilon(1e-12));
}

TEST_CASE("triangles without area don't stop it") {
    TriangleMesh mesh = shapes::sphere(1, 30);
    for (Index v = 100; v < mesh.positions.size(); v += 11) // folds triangles to segments and points
        mesh.positions[v] = mesh.positions[v - 1];
    const Result result = simplify::simplify(mesh, {.target_vertices = 300});
    CHECK(result.stop == Stop::reached);
    CHECK(std::isfinite(result.error));
    CHECK(inspect_topology(result.mesh).euler_characteristic == 2);
}

TEST_CASE("all points in one place is a mesh too") {
    TriangleMesh mesh = shapes::sphere(1, 8);
    for (Vec3& p : mesh.positions)
        p.setConstant(3);
    const Result result = simplify::simplify(mesh, {.target_vertices = 10});
    CHECK(result.mesh.positions.size() >= 10);
    CHECK(result.error == 0);
}

TEST_CASE("a vertex with thousands of triangles") {
    TriangleMesh fan;
    constexpr Index n = 3000;
    fan.positions.push_back({0, 0, 1});
    for (Index i = 0; i < n; ++i)
        fan.positions.push_back(
            {std::cos(2 * 3.14159265358979 * i / n), std::sin(2 * 3.14159265358979 * i / n), 0});
    for (Index i = 0; i < n; ++i)
        fan.triangles.push_back({0, 1 + i, 1 + (i + 1) % n});
    const Result result = simplify::simplify(fan, {.target_vertices = 100});
    CHECK(result.stop == Stop::reached);
    CHECK(inspect_topology(result.mesh).boundary_loops == 1);
    CHECK(result.original.size() == 100);
}

TEST_CASE("random triangles over few vertices") {
    for (std::uint64_t seed = 1; seed <= 40; ++seed) {
        TriangleMesh soup = shapes::sphere(1, 4);
        const std::vector<Index> a = shuffled(3 * soup.triangles.size(), seed);
        for (std::size_t f = 0; f < soup.triangles.size(); f += 2)
            for (std::size_t k = 0; k < 3; ++k)
                soup.triangles[f][k] = a[3 * f + k] % static_cast<Index>(soup.positions.size());
        const Result result = simplify::simplify(soup, {.target_vertices = 5});
        CHECK(result.mesh.positions.size() >= 5);
        CHECK(result.original.size() == result.mesh.positions.size());
        CHECK(inspect_topology(result.mesh).isolated_vertices == 0);
        for (std::size_t i = 0; i < result.original.size(); ++i)
            CHECK(result.mesh.positions[i] == soup.positions[result.original[i]]);
    }
}

TEST_CASE("what is no mesh is refused with its place") {
    TriangleMesh mesh = shapes::sphere(1, 4);
    mesh.triangles[5][1] = 999;
    CHECK_THROWS_WITH_AS(simplify::simplify(mesh, {}), doctest::Contains("triangle 5 names vertex 999"),
                         GeometryError);
    mesh = shapes::sphere(1, 4);
    mesh.positions[7][2] = NAN;
    CHECK_THROWS_WITH_AS(simplify::simplify(mesh, {}), doctest::Contains("vertex 7"), GeometryError);
}
