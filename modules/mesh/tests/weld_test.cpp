// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/mesh/weld.hpp>

#include <doctest/doctest.h>

using namespace wm3d;

TEST_CASE("positions that coincide become one vertex, numbered by first appearance") {
    const std::vector<Vec3> positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {-0.0, 1, 0}};
    const std::vector<Triangle> triangles{{0, 1, 2}, {3, 4, 5}};
    const Welded welded = weld(positions, triangles);
    CHECK(welded.mesh.positions.size() == 4);
    CHECK(welded.vertex_of == std::vector<Index>{0, 1, 2, 1, 3, 2});
    CHECK(welded.mesh.triangles == std::vector<Triangle>{{0, 1, 2}, {1, 3, 2}});
}

TEST_CASE("triangles that collapse are dropped, isolated vertices stay") {
    const std::vector<Vec3> positions{{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {5, 5, 5}};
    const std::vector<Triangle> triangles{{0, 1, 2}};
    const Welded welded = weld(positions, triangles);
    CHECK(welded.mesh.positions.size() == 3);
    CHECK(welded.mesh.triangles.empty());
}

TEST_CASE("close is not equal") {
    const std::vector<Vec3> positions{{0, 0, 0}, {1e-300, 0, 0}};
    CHECK(weld(positions, {}).mesh.positions.size() == 2);
}
