// SPDX-License-Identifier: GPL-3.0-or-later
#include "../src/canonical.hpp"

#include <doctest/doctest.h>
#include <wm3d/core/parallel.hpp>
#include <wm3d/shapes.hpp>

#include "support.hpp"

using namespace wm3d;
using namespace wm3d::simplify;
using namespace wm3d::simplify::test;

TEST_CASE("the canonical order is the same in whatever order a mesh comes, where one cell holds it all too") {
    const TriangleMesh blob = shapes::blob(40000, 3);
    const TriangleMesh speck{{Vec3::Constant(1e5), Vec3(1e5, 1e5, 1e5 + 1), Vec3(1e5, 1e5 + 1, 1e5)},
                             {{0, 1, 2}}};
    for (const TriangleMesh& mesh : {blob, joined(blob, speck), joined(speck, blob)}) {
        const Canonical order = canonical_order(mesh), other = canonical_order(reordered(mesh, 5));
        CHECK(order.positions.size() == mesh.positions.size());
        CHECK(order.positions == other.positions);
        CHECK(order.triangles == other.triangles);
    }
}

TEST_CASE("a large mesh has the same canonical order at one thread and at many") {
    const TriangleMesh mesh = reordered(shapes::torus(1, 0.4, 1100, 500), 1);
    const Canonical many = canonical_order(mesh);
    const ThreadLimit one(1);
    const Canonical told = canonical_order(mesh);
    CHECK(many.positions == told.positions);
    CHECK(many.triangles == told.triangles);
    CHECK(many.input_vertex == told.input_vertex);
}
