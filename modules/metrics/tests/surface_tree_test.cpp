// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/metrics/surface_tree.hpp>

#include <doctest/doctest.h>
#include <wm3d/core.hpp>
#include <wm3d/mesh.hpp>
#include <wm3d/shapes.hpp>

#include "../src/closest_on_triangle.hpp"

using namespace wm3d;
using namespace wm3d::metrics;

TEST_CASE("the closest point of a triangle, in all seven regions") {
    const Vec3 a(0, 0, 0), b(1, 0, 0), c(0, 1, 0);
    const auto check = [&](const Vec3& p, const Vec3& expected) {
        const Vec3 w = closest_on_triangle(p, a, b, c);
        CHECK(w.sum() == doctest::Approx(1));
        CHECK(w.minCoeff() >= 0);
        CHECK((w[0] * a + w[1] * b + w[2] * c - expected).norm() < 1e-15);
    };
    check({0.25, 0.25, 3}, {0.25, 0.25, 0});
    check({-1, -1, 1}, {0, 0, 0});
    check({2, -1, 1}, {1, 0, 0});
    check({-1, 2, 1}, {0, 1, 0});
    check({0.5, -1, 1}, {0.5, 0, 0});
    check({-1, 0.5, 1}, {0, 0.5, 0});
    check({1, 1, 1}, {0.5, 0.5, 0});
    CHECK(closest_on_triangle({1, 1, 1}, a, a, a).allFinite());
    CHECK((closest_on_triangle({0.5, 1, 0}, a, b, b) - Vec3(0.5, 0.5, 0)).norm() < 1e-15);
}

TEST_CASE("the tree finds what a search over all triangles finds") {
    const TriangleMesh mesh = shapes::blob(800, 1);
    const SurfaceTree tree(mesh);
    const TriangleMesh queries = shapes::blob(300, 2);
    for (const Vec3& q : queries.positions) {
        double best = 1e300;
        for (const Triangle& t : mesh.triangles) {
            const Vec3 w =
                closest_on_triangle(q, mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]);
            best = std::min(best, (w[0] * mesh.positions[t[0]] + w[1] * mesh.positions[t[1]] +
                                   w[2] * mesh.positions[t[2]] - q)
                                      .norm());
        }
        const ClosestPoint found = tree.closest(q);
        REQUIRE(found.distance == doctest::Approx(best).epsilon(1e-12));
        REQUIRE((found.position - q).norm() == doctest::Approx(found.distance));
    }
}

TEST_CASE("what is known of a query changes the time, not the answer") {
    const TriangleMesh mesh = shapes::blob(800, 1);
    const SurfaceTree tree(mesh);
    for (Index f = 0; f < mesh.triangles.size(); f += 7) {
        const Index corner = mesh.triangles[f][f % 3];
        const Vec3 query = mesh.positions[corner] + Vec3(0.01, -0.02, 0.005);
        const ClosestPoint plain = tree.closest(query), bounded = tree.closest(query, corner, f);
        CHECK(bounded.at.triangle == plain.at.triangle);
        CHECK(bounded.position == plain.position);
        for (Index near : {f, (f + 400) % static_cast<Index>(mesh.triangles.size())})
            CHECK(tree.closest(query, near).at.triangle == plain.at.triangle);
        const std::vector<Index> one{plain.at.triangle};
        CHECK(tree.closest_of(one, query).position == plain.position);
    }
}

TEST_CASE("triangles without area are passed over, and a mesh of nothing else is refused") {
    TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 0.9}}, {{3, 3, 3}, {0, 1, 2}}};
    CHECK(SurfaceTree(mesh).closest({0, 0, 1}).at.triangle == 1);
    mesh.triangles.pop_back();
    CHECK_THROWS_AS(SurfaceTree{mesh}, GeometryError);
}
