// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/embed/turned_faces.hpp>

#include <doctest/doctest.h>

#include <wm3d/shapes.hpp>

using namespace wm3d;
using namespace wm3d::embed;

namespace {

/// A flat square of equal triangles.
const TriangleMesh square = shapes::square(1, 8);

} // namespace

TEST_CASE("a vertex that is carried past its neighbours turns faces, and goes back as far as it has to") {
    std::vector<Vec3> moved = square.positions;
    const std::size_t inner = 40; // of 9 by 9
    moved[inner] += Vec3(0.3, 0.1, 0.05);
    moved[0] += Vec3(-0.01, 0.02, 0);
    const Vec3 elsewhere = moved[0];
    REQUIRE_FALSE(turned_faces(square, moved).empty());
    CHECK(turn_back(square, moved) >= 1);
    CHECK(turned_faces(square, moved).empty());
    const Vec3 left = moved[inner] - square.positions[inner];
    CHECK(left.norm() > 0.02);
    CHECK(left.cross(Vec3(0.3, 0.1, 0.05)).norm() < 1e-12); // in the direction that was wanted
    CHECK(moved[0] == elsewhere);
}

TEST_CASE("moves that turn nothing over stay as they are") {
    std::vector<Vec3> moved = square.positions;
    for (std::size_t i = 0; i < moved.size(); ++i)
        moved[i].z() += i % 2 == 0 ? 5 : -5; // steep, but upright
    const std::vector<Vec3> before = moved;
    CHECK(turn_back(square, moved) == 0);
    CHECK(moved == before);
}

TEST_CASE("a surface turned inside out goes back until it is upright") {
    const TriangleMesh ball = shapes::sphere(1, 6);
    std::vector<Vec3> moved = ball.positions;
    for (std::size_t i = 0; i < moved.size(); ++i)
        moved[i] = Vec3(-ball.positions[i].x(), ball.positions[i].y(), ball.positions[i].z());
    REQUIRE_FALSE(turned_faces(ball, moved).empty());
    CHECK(turn_back(ball, moved) > 0);
    CHECK(turned_faces(ball, moved).empty());
}

TEST_CASE("slivers and triangles without area may turn over") {
    const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {0.5, 0.04, 0}, {2, 0, 0}}, {{0, 1, 2}, {0, 1, 3}}};
    std::vector<Vec3> moved = mesh.positions;
    moved[2].y() = -0.04;
    CHECK(turned_faces(mesh, moved).empty());
    CHECK(turn_back(mesh, moved) == 0);
}
