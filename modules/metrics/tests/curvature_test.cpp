// SPDX-License-Identifier: GPL-3.0-or-later
#include "../src/curvature.hpp"

#include <cmath>
#include <numbers>

#include <doctest/doctest.h>
#include <wm3d/shapes.hpp>

using namespace wm3d;
using namespace wm3d::metrics;

namespace {

/// An open cylinder about z of m steps around and n along.
TriangleMesh cylinder(double radius, double height, std::size_t m, std::size_t n) {
    TriangleMesh mesh;
    for (std::size_t j = 0; j <= n; ++j)
        for (std::size_t i = 0; i < m; ++i) {
            const double a = 2 * std::numbers::pi * static_cast<double>(i) / static_cast<double>(m);
            mesh.positions.emplace_back(radius * std::cos(a), radius * std::sin(a),
                                        height * static_cast<double>(j) / static_cast<double>(n));
        }
    for (std::size_t j = 0; j < n; ++j)
        for (std::size_t i = 0; i < m; ++i) {
            const auto at = [&](std::size_t x, std::size_t y) { return static_cast<Index>(y * m + x % m); };
            mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    return mesh;
}

} // namespace

TEST_CASE("a sphere has curvature 1 / radius") {
    const TriangleMesh ball = shapes::sphere(2, 60);
    const std::vector<double> c = curvature_magnitude(ball, VertexAdjacency(ball), 0.5);
    const std::size_t equator = 1 + 29 * 120 + 7;
    CHECK(c[equator] == doctest::Approx(0.5).epsilon(0.05));
}

TEST_CASE("a cylinder has one curvature, a plane none") {
    const TriangleMesh tube = cylinder(1, 4, 100, 60);
    const std::vector<double> c = curvature_magnitude(tube, VertexAdjacency(tube), 0.4);
    CHECK(c[30 * 100 + 5] == doctest::Approx(0.5).epsilon(0.05)); // (1 + 0) / 2
    const TriangleMesh flat = shapes::square(1, 10);
    for (double value : curvature_magnitude(flat, VertexAdjacency(flat), 0.3))
        CHECK(value == doctest::Approx(0).epsilon(1e-12));
}

TEST_CASE("edges turn with the sign of the surface") {
    const TriangleMesh box = shapes::box({1, 1, 1}, 1);
    const VertexAdjacency adjacency(box);
    for (const CurvedEdge& e : adjacency.edges())
        CHECK((std::abs(e.angle) < 1e-12 || std::abs(e.angle - std::numbers::pi / 2) < 1e-12));
}

TEST_CASE("a walk stays in its ball and on its sheet") {
    const TriangleMesh flat = shapes::square(10, 10);
    const VertexAdjacency adjacency(flat);
    BallWalk walk(flat, adjacency);
    CHECK(walk.gather(60, 1.01).size() == 5);
    CHECK(walk.gather(60, 1.5).size() == 9);
    CHECK(walk.gather(0, 0.5).size() == 1);
    CHECK_FALSE(walk.contains(60));
}
