// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/mesh/umbrella.hpp>

#include <doctest/doctest.h>

#include <wm3d/core/parallel.hpp>

using namespace wm3d;

namespace {

/// A fan of six triangles around vertex 0, open on the outside, and an isolated vertex.
TriangleMesh hexagon() {
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 1},  {1, 0, 0},     {0.5, 1, 0},  {-0.5, 1, 0},
                      {-1, 0, 0}, {-0.5, -1, 0}, {0.5, -1, 0}, {9, 9, 9}};
    for (Index k = 0; k < 6; ++k)
        mesh.triangles.push_back({0, k + 1, (k + 1) % 6 + 1});
    return mesh;
}

TriangleMesh octahedron() {
    return {{{1, 0, 0}, {-1, 0, 0}, {0, 2, 0}, {0, -2, 0}, {0, 0, 3}, {0, 0, -3}},
            {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
}

double dot(const std::vector<Vec3>& a, const std::vector<Vec3>& b) {
    double sum = 0;
    for (std::size_t v = 0; v < a.size(); ++v)
        sum += a[v].dot(b[v]);
    return sum;
}

} // namespace

TEST_CASE("one step moves the inner vertex towards its neighbours' mean and nothing else") {
    const TriangleMesh mesh = hexagon();
    const std::vector<Vec3> moved = Umbrella(mesh).smooth(mesh.positions, 1, 0.1);
    CHECK((moved[0] - Vec3(0, 0, 0.9)).norm() < 1e-15);
    for (std::size_t v = 1; v < moved.size(); ++v)
        CHECK(moved[v] == mesh.positions[v]);
}

TEST_CASE("the transpose is one, on closed and on open surfaces") {
    for (const TriangleMesh& mesh : {hexagon(), octahedron()}) {
        const Umbrella umbrella(mesh);
        std::vector<Vec3> x = mesh.positions, y;
        for (std::size_t v = 0; v < x.size(); ++v)
            y.emplace_back(0.3 * static_cast<double>(v), 1 - static_cast<double>(v * v), 0.7);
        CHECK(dot(umbrella.smooth(x, 5, 0.2), y) ==
              doctest::Approx(dot(x, umbrella.smooth_transposed(y, 5, 0.2))).epsilon(1e-14));
    }
}

TEST_CASE("many steps shrink a closed surface towards a point, evenly") {
    const TriangleMesh mesh = octahedron();
    const std::vector<Vec3> moved = Umbrella(mesh).smooth(mesh.positions, 200, 0.5);
    for (const Vec3& p : moved)
        CHECK(p.norm() < 1e-12);
}
