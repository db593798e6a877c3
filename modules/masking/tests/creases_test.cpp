// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/masking/creases.hpp>

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>

#include <Eigen/Geometry>

#include <wm3d/mesh/measure.hpp>
#include <wm3d/shapes.hpp>

using namespace wm3d;
using namespace wm3d::masking;

namespace {

/// A quadrilateral of two triangles that are in one plane.
TriangleMesh book() {
    return {{Vec3(0, 0, 0), Vec3(2, 0, 0), Vec3(0.5, 1, 0), Vec3(1.2, -0.5, 0)}, {{0, 1, 2}, {1, 0, 3}}};
}

double angle(const TriangleMesh& mesh) {
    const auto normal = [&](const Triangle& t) {
        const auto& x = mesh.positions;
        return (x[t[1]] - x[t[0]]).cross(x[t[2]] - x[t[0]]).normalized();
    };
    return std::acos(std::clamp(normal(mesh.triangles[0]).dot(normal(mesh.triangles[1])), -1.0, 1.0));
}

TriangleMesh moved(TriangleMesh mesh, const std::vector<Vec3>& normals, const std::vector<double>& moves) {
    for (std::size_t i = 0; i < moves.size(); ++i)
        mesh.positions[i] += moves[i] * normals[i];
    return mesh;
}

} // namespace

TEST_CASE("a hinge turns as far as the moves of its four vertices say") {
    const TriangleMesh mesh = book();
    const std::vector<Vec3> normals = vertex_normals(mesh);
    CreaseOptions options;
    options.flat = 1;
    const Creases creases(mesh, normals);
    for (std::size_t k = 0; k < 4; ++k) {
        std::vector<double> moves(4, 0.0);
        moves[k] = 1e-5;
        CHECK(creases.worst(moves, options) ==
              doctest::Approx(angle(moved(mesh, normals, moves))).epsilon(1e-6));
    }
    CHECK(creases.worst(std::vector<double>(4, 1e-5), options) == doctest::Approx(0));
}

TEST_CASE("moves that fold a crease are taken back as far as needed, by those that move most") {
    const TriangleMesh mesh = book();
    const std::vector<Vec3> normals = vertex_normals(mesh);
    const Creases creases(mesh, normals);
    std::vector<double> moves{0, 0, 0.2, 0.02};
    creases.limit(moves);
    CHECK(angle(moved(mesh, normals, moves)) == doctest::Approx(CreaseOptions().flat).epsilon(0.05));
    CHECK(moves[0] == 0);
    CHECK(moves[1] == 0);
    CHECK(moves[2] < 0.1);
    CHECK(moves[3] == doctest::Approx(0.02).epsilon(0.2));
}

TEST_CASE("moves that fold no crease stay as they are") {
    const TriangleMesh mesh = shapes::blob(4000, 11);
    const std::vector<Vec3> normals = vertex_normals(mesh);
    const Creases creases(mesh, normals);
    std::vector<double> moves(mesh.positions.size());
    for (std::size_t i = 0; i < moves.size(); ++i)
        moves[i] = 1e-3 * std::sin(mesh.positions[i].x());
    REQUIRE(creases.worst(moves) < 1);
    const std::vector<double> before = moves;
    creases.limit(moves);
    CHECK(moves == before);
}

TEST_CASE("no hinge of a rough set of moves is left to turn too far") {
    const TriangleMesh mesh = shapes::blob(4000, 11);
    const std::vector<Vec3> normals = vertex_normals(mesh);
    CreaseOptions options;
    options.most_rounds = 2000;
    const Creases creases(mesh, normals);
    std::vector<double> moves(mesh.positions.size());
    for (std::size_t i = 0; i < moves.size(); ++i)
        moves[i] = i % 7 == 0 ? 0 : 0.02 * std::sin(1e3 * static_cast<double>(i));
    REQUIRE(creases.worst(moves) > 3);
    std::vector<double> kept = moves;
    creases.limit(kept, options);
    CHECK(creases.worst(kept) < 1.05);
    double product = 0, square = 0;
    for (std::size_t i = 0; i < moves.size(); ++i) {
        product += moves[i] * kept[i];
        square += kept[i] * kept[i];
        CHECK((moves[i] != 0 || kept[i] == 0));
    }
    CHECK(product > square); // the nearest, not any
}

TEST_CASE("positions without creases differ along the normals alone, and only where a crease was") {
    const TriangleMesh mesh = book();
    std::vector<Vec3> moved = mesh.positions;
    moved[2] += Vec3(0.01, 0, 0.2);
    const std::vector<Vec3> normals = vertex_normals(mesh);
    const Creases creases(mesh, normals);
    const std::vector<Vec3> kept = without_creases(creases, mesh, normals, moved);
    CHECK(kept[0] == moved[0]);
    CHECK(kept[1] == moved[1]);
    CHECK(kept[3] == moved[3]);
    CHECK(kept[2].x() == doctest::Approx(moved[2].x()));
    CHECK(kept[2].z() == doctest::Approx(CreaseOptions().flat).epsilon(0.05)); // its height is 1
    moved[2].z() = 0.05;
    CHECK(without_creases(creases, mesh, normals, moved) == moved);
}
