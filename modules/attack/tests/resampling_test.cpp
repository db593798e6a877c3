// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/attack/resampling.hpp>

#include <cmath>
#include <iostream>
#include <numbers>

#include <doctest/doctest.h>
#include <wm3d/core/error.hpp>
#include <wm3d/shapes.hpp>

#include "../src/fan.hpp"
#include "../src/manifold.hpp"
#include "meshes.hpp"

using namespace wm3d;
using namespace wm3d::attack;
using namespace wm3d::attack::test;

TEST_CASE("subdivision multiplies the triangles and keeps the topology") {
    for (const TriangleMesh& mesh : {shapes::torus(2, 0.6, 20, 10), shapes::blob(600, 1)})
        for (const auto& [scheme, factor] : {std::pair{SubdivisionScheme::midpoint, 4},
                                             {SubdivisionScheme::sqrt3, 3},
                                             {SubdivisionScheme::loop, 4}}) {
            const TriangleMesh fine = subdivide(mesh, scheme, 1);
            CHECK(fine.triangles.size() == factor * mesh.triangles.size());
            CHECK(inspect_topology(fine).euler_characteristic == inspect_topology(mesh).euler_characteristic);
            CHECK(is_manifold(fine));
            CHECK(enclosed_volume(fine) == doctest::Approx(enclosed_volume(mesh)).epsilon(0.1));
        }
    CHECK(subdivide(shapes::sphere(1, 6), SubdivisionScheme::loop, 2).triangles.size() == 16 * 120);
}

TEST_CASE("midpoint subdivision keeps the surface, the smoothing schemes do not") {
    const TriangleMesh box = shapes::box({1, 2, 3}, 3);
    CHECK(surface_area(subdivide(box, SubdivisionScheme::midpoint, 2)) == doctest::Approx(22).epsilon(1e-12));
    CHECK(enclosed_volume(subdivide(box, SubdivisionScheme::loop, 1)) < 5.99);
    CHECK(enclosed_volume(subdivide(box, SubdivisionScheme::sqrt3, 1)) < 5.99);
    CHECK_THROWS_AS(subdivide(box, SubdivisionScheme::loop, 12), GeometryError);
}

TEST_CASE("one Loop step has the scheme's own weights") {
    // at a vertex of valence 6 in a flat grid everything stays flat; an edge point is 3/8 3/8 1/8 1/8
    TriangleMesh mesh = shapes::square(4, 4);
    mesh.positions[12][2] = 1; // the middle vertex, valence 6
    const TriangleMesh fine = subdivide(mesh, SubdivisionScheme::loop, 1);
    double top = 0;
    for (const Vec3& p : fine.positions)
        top = std::max(top, p[2]);
    CHECK(top == doctest::Approx(5.0 / 8)); // 1 - 6 beta with beta = 1/16
}

TEST_CASE("vertices of any number of neighbours have the schemes' weights") {
    for (Index around : {8u, 49u, 50u, 400u}) {
        CAPTURE(around);
        TriangleMesh cones{{{0, 0, 1}, {0, 0, -1}}, {}};
        for (Index k = 0; k < around; ++k) {
            const double angle = 2 * std::numbers::pi * k / around;
            cones.positions.emplace_back(std::cos(angle), std::sin(angle), 0);
            const Index next = 2 + (k + 1) % around;
            cones.triangles.push_back({0, 2 + k, next});
            cones.triangles.push_back({1, next, 2 + k});
        }
        const double cosine = std::cos(2 * std::numbers::pi / around);
        const auto top = [&](SubdivisionScheme scheme) {
            return subdivide(cones, scheme, 1).positions[0].z(); // the rim's centre is at 0
        };
        CHECK(top(SubdivisionScheme::loop) == doctest::Approx(3.0 / 8 + std::pow(3.0 / 8 + cosine / 4, 2)));
        CHECK(top(SubdivisionScheme::sqrt3) == doctest::Approx(1 - (4 - 2 * cosine) / 9));
    }
}

TEST_CASE("simplification removes the wanted share of the edges and keeps the topology") {
    for (const TriangleMesh& mesh : {shapes::blob(4000, 1), shapes::torus(2, 0.6, 80, 30)})
        for (double percent : {10.0, 50.0, 90.0, 97.5}) {
            const TriangleMesh coarse = simplify_edges(mesh, percent);
            const Topology before = inspect_topology(mesh), after = inspect_topology(coarse);
            const double removed =
                100 - 100 * static_cast<double>(after.edges) / static_cast<double>(before.edges);
            CHECK(std::abs(removed - percent) < 1);
            CHECK(after.euler_characteristic == before.euler_characteristic);
            CHECK(is_manifold(coarse));
            if (percent <= 90)
                CHECK(enclosed_volume(coarse) == doctest::Approx(enclosed_volume(mesh)).epsilon(0.01));
        }
}

TEST_CASE("remeshing keeps the surface and brings the edges to the target") {
    const TriangleMesh mesh = shapes::blob(4000, 1);
    for (double factor : {0.8, 1.0, 1.5}) {
        const TriangleMesh remeshed = remesh_isotropic(mesh, {factor, 5});
        // the input's edges are counted once each, as the target is
        CHECK(mean_edge(remeshed) == doctest::Approx(factor * mean_edge(mesh)).epsilon(0.1));
        CHECK(inspect_topology(remeshed).euler_characteristic == 2);
        CHECK(enclosed_volume(remeshed) == doctest::Approx(enclosed_volume(mesh)).epsilon(0.01));
        CHECK(remeshed.positions != mesh.positions);
    }
}

TEST_CASE("voxel extraction gives a closed surface of the same place and volume") {
    if (!has_voxels()) {
        std::cout << "SKIPPED: this build has no OpenVDB\n";
        return;
    }
    const TriangleMesh mesh = shapes::blob(4000, 1);
    const TriangleMesh extracted = extract_voxels(mesh, 64);
    CHECK(inspect_topology(extracted).boundary_edges == 0);
    CHECK(enclosed_volume(extracted) == doctest::Approx(enclosed_volume(mesh)).epsilon(0.01));
    const Box box = bounding_box(mesh.positions), again = bounding_box(extracted.positions);
    const double voxel = (box.max - box.min).maxCoeff() / 64;
    CHECK((box.min - again.min).cwiseAbs().maxCoeff() < voxel);
    CHECK((box.max - again.max).cwiseAbs().maxCoeff() < voxel);

    TriangleMesh punctured = mesh; // a hole must not turn the model into a shell
    punctured.triangles.erase(punctured.triangles.begin() + 500, punctured.triangles.begin() + 501);
    CHECK(enclosed_volume(extract_voxels(punctured, 64)) ==
          doctest::Approx(enclosed_volume(mesh)).epsilon(0.01));
}

TEST_CASE("holes are closed by fans") {
    TriangleMesh ball = shapes::sphere(1, 8);
    ball.triangles.pop_back();
    ball.triangles.erase(ball.triangles.begin());
    CHECK(inspect_topology(ball).boundary_edges == 6);
    CHECK(inspect_topology(close_with_fans(ball)).boundary_edges == 0);
    CHECK(inspect_topology(close_with_fans(ball)).euler_characteristic == 2);
    CHECK(same(close_with_fans(shapes::sphere(1, 8)), shapes::sphere(1, 8)));
}

TEST_CASE("any triangles become an oriented manifold, and a manifold keeps its order") {
    const TriangleMesh manifold = make_manifold(hostile());
    CHECK(is_manifold(manifold));
    CHECK(manifold.triangles.size() == 7); // the repeated one is dropped
    CHECK(surface_area(manifold) > 0);
    const TriangleMesh blob = shapes::blob(500, 1);
    CHECK(same(make_manifold(blob), blob));
    CHECK_THROWS_AS(make_manifold({{{0, 0, 0}, {1, 0, 0}}, {{0, 1, 1}}}), GeometryError);
}
