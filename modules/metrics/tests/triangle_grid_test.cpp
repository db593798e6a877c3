// SPDX-License-Identifier: GPL-3.0-or-later
#include "../src/triangle_grid.hpp"

#include <numeric>

#include <doctest/doctest.h>
#include <wm3d/core/split_mix.hpp>
#include <wm3d/mesh.hpp>
#include <wm3d/shapes.hpp>

#include "../src/edge_graph.hpp"

using namespace wm3d;
using namespace wm3d::metrics;

namespace {

std::vector<Index> all_of(const TriangleMesh& mesh) {
    std::vector<Index> numbers(mesh.triangles.size());
    std::iota(numbers.begin(), numbers.end(), Index{0});
    return numbers;
}

/// A blob with a second sheet close above some of it, anywhere and of any size.
TriangleMesh sheets(double size, const Vec3& place) {
    TriangleMesh mesh = shapes::blob(2000, 1);
    const std::size_t triangles = mesh.triangles.size();
    for (std::size_t f = 0; f < triangles; f += 5) {
        const auto first = static_cast<Index>(mesh.positions.size());
        for (std::size_t k = 0; k < 3; ++k)
            mesh.positions.push_back(1.0005 * mesh.positions[mesh.triangles[f][k]]);
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    for (Vec3& p : mesh.positions)
        p = size * p + place;
    return mesh;
}

} // namespace

TEST_CASE("the grid finds where a vertex went, as the tree does") {
    for (const double size : {1.0, 1e-12, 1e9}) {
        CAPTURE(size);
        const TriangleMesh mesh = sheets(size, size * Vec3(0.3, -2, 5));
        const EdgeGraph graph(mesh);
        const TriangleBoxes boxes(mesh, all_of(mesh));
        const auto grid = TriangleGrid::over(mesh, all_of(mesh));
        REQUIRE(grid);
        std::size_t elsewhere = 0;
        for (Index v = 0; v < mesh.positions.size(); ++v) {
            const auto part = [&](std::uint64_t k) {
                return 2 * static_cast<double>(split_mix_finalizer(3 * v + k + 1) >> 11) /
                           9007199254740992.0 -
                       1;
            };
            const double reach = std::pow(10, -1 - static_cast<double>(v % 5));
            const Vec3 query = mesh.positions[v] + size * reach * Vec3(part(0), part(1), part(2));
            const std::optional<Index> found = grid->nearest(query, v, graph.triangles_at(v));
            if (!found) // a long way
                continue;
            const NearestTriangle expected = boxes.nearest(query);
            REQUIRE(*found == expected.triangle);
            elsewhere +=
                std::ranges::find(graph.triangles_at(v), *found) == graph.triangles_at(v).end() ? 1 : 0;
        }
        CHECK(elsewhere > 300);
    }
}

TEST_CASE("what a vertex is clear of is farther, and as far as was asked where triangles are even") {
    const double most = 0.01;
    for (const TriangleMesh& mesh : {sheets(3, Vec3(1, 2, 3)), shapes::blob(2000, 1)}) {
        const TriangleBoxes boxes(mesh, all_of(mesh));
        const auto grid = TriangleGrid::over(mesh, all_of(mesh));
        REQUIRE(grid);
        const std::vector<double> exact = boxes.clearances(most), clear = grid->clearances(most);
        REQUIRE(clear.size() == exact.size());
        std::size_t wide = 0;
        for (std::size_t v = 0; v < clear.size(); ++v) {
            REQUIRE(clear[v] >= 0);
            REQUIRE(clear[v] <= exact[v]);
            wide += clear[v] > 0.99 * most ? 1 : 0;
        }
        if (mesh.positions.size() == 2000)
            CHECK(wide > 1000);
    }
}

TEST_CASE("the grid leaves out what it wasn't given, and vertices of nothing else") {
    const TriangleMesh mesh = shapes::blob(500, 1);
    const EdgeGraph graph(mesh);
    std::vector<Index> some = all_of(mesh);
    const std::span<const Index> around = graph.triangles_at(7);
    std::erase_if(some, [&](Index f) { return std::ranges::find(around, f) != around.end(); });
    const auto grid = TriangleGrid::over(mesh, some);
    REQUIRE(grid);
    CHECK_FALSE(grid->nearest(mesh.positions[7], 7, around));
    const Index beside =
        mesh.triangles[around[0]][0] == 7 ? mesh.triangles[around[0]][1] : mesh.triangles[around[0]][0];
    const auto found = grid->nearest(mesh.positions[beside], beside, graph.triangles_at(beside));
    REQUIRE(found);
    CHECK(std::ranges::find(around, *found) == around.end());
}

TEST_CASE("no grid is made where long triangles would meet most of its cells") {
    TriangleMesh mesh = shapes::blob(2000, 1);
    const auto first = static_cast<Index>(mesh.positions.size());
    for (const Vec3& p : {Vec3(-1, -1, -1), Vec3(1, 1, 1), Vec3(1, 0.9, 1)})
        mesh.positions.push_back(p);
    for (int k = 0; k < 300; ++k)
        mesh.triangles.push_back({first, first + 1, first + 2});
    CHECK_FALSE(TriangleGrid::over(mesh, all_of(mesh)));
}

TEST_CASE("a vertex that went far, or out of sight, is left to others") {
    const TriangleMesh mesh = shapes::blob(2000, 1);
    const EdgeGraph graph(mesh);
    const auto grid = TriangleGrid::over(mesh, all_of(mesh));
    REQUIRE(grid);
    for (const double away : {1.0, 1e3, 1e30})
        CHECK_FALSE(grid->nearest(mesh.positions[0] + Vec3(away, 0, 0), 0, graph.triangles_at(0)));
}
