// SPDX-License-Identifier: GPL-3.0-or-later
#include "../src/curvature.hpp"

#include <cmath>
#include <numbers>

#include <doctest/doctest.h>
#include <wm3d/shapes.hpp>

using namespace wm3d;
using namespace wm3d::metrics;

namespace {

/// An open cylinder about z of m steps around and n along, of
/// triangles with nearly equal sides: among slender ones walks outwards miss much of a ball.
TriangleMesh cylinder(double radius, double height, std::size_t m, std::size_t n) {
    TriangleMesh mesh;
    for (std::size_t j = 0; j <= n; ++j)
        for (std::size_t i = 0; i < m; ++i) {
            const double a = 2 * std::numbers::pi / static_cast<double>(m) *
                             (static_cast<double>(i) - 0.5 * static_cast<double>(j));
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

namespace {

std::vector<PerScale> magnitudes(const TriangleMesh& mesh, const PerScale& radii) {
    const EdgeGraph graph(mesh);
    return curvature_magnitudes(mesh, graph, bends_of(mesh, graph), radii);
}

/// At one vertex and radius.
double curvature_at(const TriangleMesh& mesh, std::size_t vertex, double radius) {
    return magnitudes(mesh, {radius, radius, radius})[vertex][0];
}

} // namespace

TEST_CASE("a sphere has curvature 1 / radius") {
    const TriangleMesh ball = shapes::sphere(2, 60);
    const std::size_t equator = 1 + 29 * 120 + 7;
    CHECK(curvature_at(ball, equator, 0.5) == doctest::Approx(0.5).epsilon(0.05));
}

TEST_CASE("a cylinder has one curvature, a plane none") {
    const TriangleMesh tube = cylinder(1, 4, 100, 72);
    CHECK(curvature_at(tube, 36 * 100 + 5, 0.4) == doctest::Approx(0.5).epsilon(0.05)); // (1 + 0) / 2
    const TriangleMesh flat = shapes::square(1, 10);
    for (const PerScale& values : magnitudes(flat, {0.1, 0.2, 0.3}))
        for (double value : values)
            CHECK(value == doctest::Approx(0).epsilon(1e-12));
}

TEST_CASE("several radii in one walk give what each gives alone") {
    const TriangleMesh mesh = shapes::blob(3000, 1);
    const PerScale radii{0.02, 0.05, 0.11};
    const std::vector<PerScale> together = magnitudes(mesh, radii);
    for (std::size_t k = 0; k < radii.size(); ++k) {
        const auto alone = magnitudes(mesh, {radii[k], radii[k], radii[k]});
        for (std::size_t v = 0; v < mesh.positions.size(); ++v)
            REQUIRE(together[v][k] == doctest::Approx(alone[v][0]).epsilon(1e-9));
    }
}
