// SPDX-License-Identifier: GPL-3.0-or-later
#include "../src/residual.hpp"

#include <cmath>
#include <numbers>

#include <Eigen/Geometry>
#include <doctest/doctest.h>

#include <wm3d/mesh/frame.hpp>
#include <wm3d/mesh/measure.hpp>
#include <wm3d/shapes.hpp>

#include "support.hpp"

using namespace wm3d;
using detect::Hinges;
using detect::test::dot;

namespace {

/// Two triangles at the edge from (0, 0, 0) to (2, 0, 0), the second turned up by an angle.
TriangleMesh hinge(double angle) {
    return {{{0, 0, 0}, {2, 0, 0}, {1, 1, 0}, {1, -std::cos(angle), std::sin(angle)}},
            {{0, 1, 2}, {1, 0, 3}}};
}

std::vector<double> some_numbers(std::size_t count) {
    std::vector<double> x(count);
    for (std::size_t i = 0; i < count; ++i)
        x[i] = std::sin(1.7 * static_cast<double>(i) + 0.3);
    return x;
}

} // namespace

TEST_CASE("a fold is the distance of two triangles from one plane") {
    for (double angle : {0.0, 0.3, -0.7, 1.5}) {
        CAPTURE(angle);
        const TriangleMesh mesh = hinge(angle);
        const std::vector<Vec3> normals = vertex_normals(mesh);
        const Hinges hinges(mesh, normals);
        REQUIRE(hinges.size() == 1);
        // c = (-1, -1, 1, 1) / 2; both corners are sin(angle / 2) above the edge along the mean normal.
        CHECK(hinges.folds()[0] == doctest::Approx(std::sin(angle / 2)).epsilon(1e-12));
    }
}

TEST_CASE("folds turn and scale with the mesh, and moves of one plane fold nothing") {
    TriangleMesh mesh = shapes::blob(800, 3);
    const std::vector<Vec3> normals = vertex_normals(mesh);
    const Hinges as_made(mesh, normals);
    const std::span<const double> folds = as_made.folds();
    const Mat3 turn = Eigen::AngleAxisd(0.8, Vec3(1, -2, 3).normalized()).toRotationMatrix();
    for (Vec3& p : mesh.positions)
        p = 3 * (turn * p) + Vec3(10, 20, 30);
    const Hinges as_moved(mesh, normals);
    const std::span<const double> moved = as_moved.folds();
    REQUIRE(moved.size() == folds.size());
    REQUIRE(folds.size() == 3 * mesh.triangles.size() / 2); // closed
    for (std::size_t h = 0; h < folds.size(); ++h)
        CHECK(moved[h] == doctest::Approx(3 * folds[h]).epsilon(1e-9).scale(1e-3));

    const TriangleMesh flat = shapes::square(1, 12);
    const std::vector<Vec3> up(flat.positions.size(), Vec3::UnitZ());
    std::vector<double> tilt;
    for (const Vec3& p : flat.positions)
        tilt.push_back(0.3 + 0.2 * p.x() - 0.5 * p.y());
    for (double r : Hinges(flat, up).folds_of(tilt))
        CHECK(std::abs(r) < 1e-14);
}

TEST_CASE("what is pulled back is the transpose of what moves fold, and the gradient its direction") {
    const TriangleMesh mesh = shapes::blob(800, 3);
    const std::vector<Vec3> normals = vertex_normals(mesh);
    const Hinges hinges(mesh, normals);
    const std::vector<double> q = some_numbers(mesh.positions.size()), y = some_numbers(hinges.size());
    CHECK(dot(hinges.folds_of(q), y) == doctest::Approx(dot(q, hinges.transposed(y))).epsilon(1e-12));
    const std::vector<Vec3> gradient = hinges.gradient(mesh.positions, y);
    const std::vector<double> pulled = hinges.transposed(y);
    for (std::size_t i = 0; i < pulled.size(); ++i)
        CHECK(gradient[i].dot(normals[i]) == doctest::Approx(pulled[i]).epsilon(1e-9).scale(1));
}

TEST_CASE("folds follow small moves along the normals") {
    TriangleMesh mesh = shapes::blob(800, 3);
    const std::vector<Vec3> normals = vertex_normals(mesh);
    const Hinges before(mesh, normals);
    const std::vector<double> q = some_numbers(mesh.positions.size()), expected = before.folds_of(q);
    constexpr double step = 1e-6;
    for (std::size_t i = 0; i < q.size(); ++i)
        mesh.positions[i] += step * q[i] * normals[i];
    const Hinges after(mesh, normals);
    const std::span<const double> r = before.folds(), s = after.folds();
    double error = 0, size = 0;
    for (std::size_t h = 0; h < r.size(); ++h) {
        error += std::pow((s[h] - r[h]) / step - expected[h], 2);
        size += std::pow(expected[h], 2);
    }
    CHECK(std::sqrt(error / size) < 0.05); // c and n turn a little with the triangles
}

TEST_CASE("borders, edges of three triangles, doubled and folded back ones are no hinges") {
    TriangleMesh mesh = hinge(0.3);
    mesh.positions.push_back({1, 0, 2});
    mesh.triangles.push_back({0, 1, 4});
    CHECK(Hinges(mesh, vertex_normals(mesh)).size() == 0);
    mesh = hinge(0.3);
    mesh.triangles[1] = {1, 0, 2};
    CHECK(Hinges(mesh, vertex_normals(mesh)).size() == 0); // one triangle twice, at each of its edges
    mesh = hinge(std::numbers::pi);
    CHECK(Hinges(mesh, vertex_normals(mesh)).size() == 0);
    mesh = hinge(0.3);
    mesh.positions[3] = {1.5, 0, 0};
    CHECK(Hinges(mesh, vertex_normals(mesh)).size() == 0); // a triangle without area
}

TEST_CASE("squares are the diagonal of J^T g J") {
    const TriangleMesh mesh = shapes::blob(200, 3);
    const std::vector<Vec3> normals = vertex_normals(mesh);
    const Hinges hinges(mesh, normals);
    std::vector<double> g = some_numbers(hinges.size());
    for (double& x : g)
        x = 2 + x;
    const std::vector<double> squares = hinges.squares(g);
    std::vector<double> move(mesh.positions.size(), 0.0);
    for (std::size_t i = 0; i < move.size(); ++i) {
        move[i] = 1;
        const std::vector<double> folds = hinges.folds_of(move);
        double sum = 0;
        for (std::size_t h = 0; h < folds.size(); ++h)
            sum += g[h] * folds[h] * folds[h];
        CHECK(squares[i] == doctest::Approx(sum).epsilon(1e-12));
        move[i] = 0;
    }
}

TEST_CASE("whitened folds are (I + noise^2 J^T g J)^-1 J^T (g r)") {
    constexpr double scale = 1e-3, noise = 2e-3;
    const TriangleMesh blob = shapes::blob(1500, 3);
    const TriangleMesh mesh = to_frame(blob, canonical_frame(blob));
    const std::vector<Vec3> normals = vertex_normals(mesh);
    const Hinges hinges(mesh, normals);
    const std::vector<double> r(hinges.folds().begin(), hinges.folds().end());
    const auto weighted = [&](std::vector<double> folds) {
        for (std::size_t h = 0; h < folds.size(); ++h)
            folds[h] /= r[h] * r[h] + scale * scale;
        return hinges.transposed(folds);
    };
    const std::vector<double> right = weighted(r);
    const auto residual = detect::hinge_residual(hinges, mesh.positions, scale, noise);
    const std::vector<double> q(residual->pulled().begin(), residual->pulled().end());
    const std::vector<double> back = weighted(hinges.folds_of(q));
    std::vector<double> g(r.size());
    for (std::size_t h = 0; h < r.size(); ++h)
        g[h] = 1 / (r[h] * r[h] + scale * scale);
    const std::vector<double> squares = hinges.squares(g);
    double error = 0, size = 0; // in the norm of the diagonal's inverse
    for (std::size_t i = 0; i < q.size(); ++i) {
        const double diagonal = 1 + noise * noise * squares[i];
        error += std::pow(q[i] + noise * noise * back[i] - right[i], 2) / diagonal;
        size += right[i] * right[i] / diagonal;
    }
    CHECK(std::sqrt(error / size) < 1.01 * detect::whitening_tolerance);
    // Without noise nothing is solved.
    const auto plain = detect::hinge_residual(hinges, mesh.positions, scale, 0);
    for (std::size_t i = 0; i < right.size(); ++i)
        CHECK(plain->pulled()[i] == doctest::Approx(right[i]).epsilon(1e-9).scale(std::sqrt(size)));
}
