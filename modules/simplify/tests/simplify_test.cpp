// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/simplify.hpp>

#include <doctest/doctest.h>
#include <wm3d/shapes.hpp>

using namespace wm3d;

TEST_CASE("a sphere reaches its target") {
    const auto result = simplify::simplify(shapes::sphere(1, 40), {.target_vertices = 200});
    CHECK(result.stop == simplify::Stop::reached);
    CHECK(result.mesh.positions.size() == 200);
    CHECK(result.mesh.triangles.size() == 396);
}
