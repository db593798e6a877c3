// SPDX-License-Identifier: GPL-3.0-or-later
#include "../src/triangle_boxes.hpp"

#include <doctest/doctest.h>
#include <wm3d/mesh.hpp>
#include <wm3d/shapes.hpp>

#include "../src/closest_on_triangle.hpp"

using namespace wm3d;
using namespace wm3d::metrics;

namespace {

std::vector<TriangleBoxes::Corners> corners_of(const TriangleMesh& mesh, std::size_t count) {
    std::vector<TriangleBoxes::Corners> corners;
    for (Index f = 0; f < count; ++f) {
        const Triangle& t = mesh.triangles[f];
        corners.push_back({mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]], f});
    }
    return corners;
}

NearestTriangle by_search(const std::vector<TriangleBoxes::Corners>& corners, const Vec3& query) {
    NearestTriangle best;
    for (const auto& t : corners)
        improve(best, t.triangle, squared_distance_to_triangle(query, t.a, t.b, t.c));
    return best;
}

} // namespace

TEST_CASE("trees of any number of triangles find what a search over all finds") {
    const TriangleMesh mesh = shapes::blob(600, 1);
    const TriangleMesh queries = shapes::blob(60, 2);
    for (std::size_t count : {1UL, 2UL, 3UL, 4UL, 5UL, 7UL, 8UL, 9UL, 16UL, 17UL, 31UL, 100UL, 599UL}) {
        const auto corners = corners_of(mesh, count);
        const TriangleBoxes boxes(corners);
        for (const Vec3& q : queries.positions) {
            const auto expected = by_search(corners, q), found = boxes.nearest(q);
            REQUIRE(found.square == expected.square);
            REQUIRE(found.triangle == expected.triangle);
        }
    }
}

TEST_CASE("some triangles may be left out of a search") {
    const TriangleMesh mesh = shapes::blob(300, 1);
    auto corners = corners_of(mesh, mesh.triangles.size());
    const TriangleBoxes boxes(corners);
    const Vec3 query = mesh.positions[7];
    std::vector<Index> left_out;
    for (int i = 0; i < 9; ++i) {
        const auto expected = by_search(corners, query), found = boxes.nearest_but(left_out, query);
        CHECK(found.triangle == expected.triangle);
        CHECK(found.square == expected.square);
        left_out.push_back(found.triangle);
        std::erase_if(corners, [&](const auto& t) { return t.triangle == found.triangle; });
    }
    CHECK(TriangleBoxes(corners_of(mesh, 1)).nearest_but(std::vector<Index>{0}, query).triangle == no_index);
}

TEST_CASE("of triangles that are equally close, the lowest number is found, whatever was known before") {
    const TriangleMesh mesh = shapes::sphere(1, 12);
    const auto corners = corners_of(mesh, mesh.triangles.size());
    const TriangleBoxes boxes(corners);
    for (const Vec3& p : mesh.positions) { // every vertex lies on several triangles
        const auto expected = by_search(corners, p);
        CHECK(boxes.nearest(p).triangle == expected.triangle);
        for (Index likely : {Index{0}, static_cast<Index>(mesh.triangles.size() - 1)}) {
            const auto& t = corners[likely];
            CHECK(boxes.nearest(p, {likely, squared_distance_to_triangle(p, t.a, t.b, t.c)}).triangle ==
                  expected.triangle);
        }
    }
}
