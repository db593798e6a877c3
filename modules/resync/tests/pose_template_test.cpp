// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/resync/pose_template.hpp>

#include <doctest/doctest.h>

#include <wm3d/core/error.hpp>
#include <wm3d/shapes/shapes.hpp>

using namespace wm3d;

TEST_CASE("a template's points lie on the surface, evenly, with its normals") {
    const resync::PoseTemplate sampled = resync::make_template(shapes::sphere(2, 60), 2000);
    REQUIRE(sampled.points.size() == 2000);
    std::size_t upper = 0;
    for (std::size_t i = 0; i < sampled.points.size(); ++i) {
        CHECK(sampled.points[i].norm() == doctest::Approx(2).epsilon(2e-3));
        CHECK(sampled.normals[i].dot(sampled.points[i].normalized()) > 0.99);
        upper += sampled.points[i].z() > 0;
    }
    CHECK(upper == doctest::Approx(1000).epsilon(0.01));
}

TEST_CASE("triangles without area get no points, a surface without area no template") {
    TriangleMesh mesh = shapes::square(1, 2);
    mesh.triangles.insert(mesh.triangles.begin(), Triangle{0, 0, 1});
    mesh.triangles.push_back({2, 2, 2});
    for (const Vec3& n : resync::make_template(mesh, 50).normals)
        CHECK(n.z() == doctest::Approx(1));
    CHECK_THROWS_AS(resync::make_template({{Vec3::Zero()}, {{0, 0, 0}}}, 10), GeometryError);
    CHECK_THROWS_AS(resync::make_template(mesh, 0), ParameterError);
}
