// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Passes over lists so long that several threads share them.
#include <array>
#include <cmath>
#include <vector>

#include <doctest/doctest.h>

#include <wm3d/core/parallel.hpp>
#include <wm3d/mesh/curve_order.hpp>
#include <wm3d/mesh/measure.hpp>
#include <wm3d/mesh/sides.hpp>
#include <wm3d/mesh/topology.hpp>

#include "support.hpp"

using namespace wm3d;
using namespace wm3d::test;

namespace {

/// A hilly square of more than a million triangles, its vertices in no useful order.
TriangleMesh hills() {
    TriangleMesh mesh = shuffled_square(730);
    for (Vec3& p : mesh.positions)
        p.z() = std::sin(0.3 * p.x()) * std::cos(0.2 * p.y());
    return mesh;
}

/// What threads share, in numbers.
struct Told {
    std::vector<Vec3> normals, positions;
    std::vector<double> areas;
    std::vector<Triangle> triangles;
    std::vector<std::array<Index, 4>> sides;
    std::vector<double> borders;
    Box box;

    explicit Told(const TriangleMesh& mesh)
        : normals(vertex_normals(mesh)), areas(vertex_areas(mesh)), box(surface_box(mesh)) {
        const Reordered along = along_curve(mesh);
        positions = along.mesh.positions;
        triangles = along.mesh.triangles;
        for (const Side& s : sorted_sides(mesh))
            sides.push_back({s.low, s.high, s.forward ? 1u : 0u, s.triangle});
        for (const BorderLoop& loop : border_loops(mesh))
            borders.insert(borders.end(),
                           {static_cast<double>(loop.edges), loop.length, loop.opening.norm()});
    }
};

} // namespace

TEST_CASE("a large mesh has the same normals, areas, sides, borders and order at one thread and at many") {
    const TriangleMesh mesh = hills();
    const Told many(mesh);
    const ThreadLimit one(1);
    const Told told(mesh);
    CHECK(many.normals == told.normals);
    CHECK(many.areas == told.areas);
    CHECK(many.positions == told.positions);
    CHECK(many.triangles == told.triangles);
    CHECK(many.sides == told.sides);
    CHECK(many.borders == told.borders);
    CHECK(many.borders.at(0) == 4 * 730);
    CHECK(many.box.min == told.box.min);
    CHECK(many.box.max == told.box.max);
    CHECK(many.box.max.x() == 730);
}
