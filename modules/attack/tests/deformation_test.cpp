// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/attack/deformation.hpp>

#include <cmath>
#include <numbers>

#include <doctest/doctest.h>
#include <wm3d/attack/perturbation.hpp>
#include <wm3d/core/error.hpp>
#include <wm3d/shapes.hpp>

#include "meshes.hpp"

using namespace wm3d;
using namespace wm3d::attack;
using namespace wm3d::attack::test;

TEST_CASE("a random similarity is one, within the benchmark's ranges") {
    const TriangleMesh mesh = shapes::blob(300, 1);
    const double d = mean_vertex_distance(mesh);
    for (std::uint64_t seed = 0; seed < 50; ++seed) {
        const Similarity s = random_similarity(d, seed);
        CHECK((s.rotation * s.rotation.transpose() - Mat3::Identity()).norm() < 1e-14);
        CHECK(s.rotation.determinant() == doctest::Approx(1));
        CHECK(s.scale >= 0.1);
        CHECK(s.scale < 10);
        CHECK(s.translation.cwiseAbs().maxCoeff() <= 5 * d);
    }
}

TEST_CASE("a similarity keeps distances up to its scale") {
    const TriangleMesh mesh = shapes::blob(300, 1);
    const Similarity s = random_similarity(mean_vertex_distance(mesh), 4);
    const TriangleMesh moved = transform(mesh, s);
    for (std::size_t v = 1; v < mesh.positions.size(); ++v)
        REQUIRE((moved.positions[v] - moved.positions[v - 1]).norm() ==
                doctest::Approx(s.scale * (mesh.positions[v] - mesh.positions[v - 1]).norm()).epsilon(1e-10));
    CHECK(enclosed_volume(moved) ==
          doctest::Approx(std::pow(s.scale, 3) * enclosed_volume(mesh)).epsilon(1e-9));
}

TEST_CASE("rotations have no preferred direction") {
    Vec3 sum = Vec3::Zero();
    constexpr int count = 4000;
    for (std::uint64_t seed = 0; seed < count; ++seed) {
        const Mat3 r = random_similarity(1, seed).rotation;
        sum += Vec3(r(2, 1) - r(1, 2), r(0, 2) - r(2, 0), r(1, 0) - r(0, 1)); // along the axis
    }
    CHECK(sum.norm() / count < 0.08);
}

TEST_CASE("linear maps multiply the volume by their determinant") {
    const TriangleMesh mesh = shapes::blob(500, 1);
    CHECK(enclosed_volume(transform(mesh, Mat3(Vec3(1.2, 1, 0.5).asDiagonal()))) ==
          doctest::Approx(0.6 * enclosed_volume(mesh)));
    Mat3 shear = Mat3::Identity();
    shear(0, 2) = 0.3;
    CHECK(enclosed_volume(transform(mesh, shear)) == doctest::Approx(enclosed_volume(mesh)));
    CHECK_THROWS_AS(transform(mesh, Mat3(Vec3(1, 0, 1).asDiagonal())), ParameterError);
}

TEST_CASE("bending makes an arc of the given angle") {
    const TriangleMesh bar = shapes::box({10, 2, 1}, 20);
    const TriangleMesh bent = bend(bar, 60);
    const double radius = 10 / (std::numbers::pi / 3);
    const Vec3 hub{5, 1 + radius, 0};
    for (std::size_t v = 0; v < bar.positions.size(); ++v) {
        const Vec3 from_hub = (bent.positions[v] - hub).cwiseProduct(Vec3(1, 1, 0));
        REQUIRE(from_hub.norm() == doctest::Approx(radius - (bar.positions[v][1] - 1)).epsilon(1e-12));
        REQUIRE(std::atan2(from_hub[0], -from_hub[1]) == doctest::Approx((bar.positions[v][0] - 5) / radius));
    }
    CHECK(same(bend(bar, 0), bar));
}
