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

using namespace wm3d;

namespace {

/// A hilly square of more than a million triangles, its vertices in no useful order.
TriangleMesh hills() {
    constexpr Index cells = 730, side = cells + 1, count = side * side;
    const auto number = [](Index i, Index j) {
        return static_cast<Index>(std::size_t{i * side + j} * 7919 % count);
    };
    TriangleMesh mesh;
    mesh.positions.resize(count);
    for (Index i = 0; i < side; ++i)
        for (Index j = 0; j < side; ++j)
            mesh.positions[number(i, j)] = Vec3(i, j, std::sin(0.3 * i) * std::cos(0.2 * j));
    for (Index i = 0; i < cells; ++i)
        for (Index j = 0; j < cells; ++j) {
            mesh.triangles.push_back({number(i, j), number(i + 1, j), number(i + 1, j + 1)});
            mesh.triangles.push_back({number(i, j), number(i + 1, j + 1), number(i, j + 1)});
        }
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
