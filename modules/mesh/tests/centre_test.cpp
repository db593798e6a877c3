// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/mesh/centre.hpp>

#include <doctest/doctest.h>

using namespace wm3d;

TEST_CASE("the mean of the vertices counts each once, however large its triangles are") {
    TriangleMesh mesh;
    mesh.positions = {{0, 0, 0}, {8, 0, 0}, {0, 4, 0}, {0, 0, -2}};
    mesh.triangles = {{0, 1, 2}};
    CHECK(vertex_mean(mesh) == Vec3(2, 1, -0.5));
}

TEST_CASE("the mean of many vertices is that of the few that repeat") {
    TriangleMesh mesh;
    for (int k = 0; k < 100'000; ++k)
        mesh.positions.emplace_back(k % 2, 3, k % 4);
    CHECK(vertex_mean(mesh) == Vec3(0.5, 3, 1.5));
}
