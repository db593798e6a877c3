// SPDX-License-Identifier: GPL-3.0-or-later
#include "../src/triangle_boxes.hpp"

#include <numeric>

#include <doctest/doctest.h>
#include <wm3d/mesh.hpp>
#include <wm3d/shapes.hpp>

#include "../src/closest_on_triangle.hpp"

using namespace wm3d;
using namespace wm3d::metrics;

namespace {

std::vector<NumberedTriangle> corners_of(const TriangleMesh& mesh, std::size_t count) {
    std::vector<NumberedTriangle> corners;
    for (Index f = 0; f < count; ++f) {
        const Triangle& t = mesh.triangles[f];
        corners.push_back({mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]], f});
    }
    return corners;
}

std::vector<Index> first(std::size_t count) {
    std::vector<Index> numbers(count);
    std::iota(numbers.begin(), numbers.end(), Index{0});
    return numbers;
}

NearestTriangle by_search(const std::vector<NumberedTriangle>& corners, const Vec3& query) {
    NearestTriangle best;
    for (const auto& t : corners)
        best.improve(query, t);
    return best;
}

} // namespace

TEST_CASE("trees of any number of triangles find what a search over all finds") {
    const TriangleMesh mesh = shapes::blob(600, 1);
    const TriangleMesh queries = shapes::blob(60, 2);
    for (std::size_t count : {1UL, 2UL, 3UL, 4UL, 5UL, 7UL, 8UL, 9UL, 16UL, 17UL, 31UL, 100UL, 599UL}) {
        const auto corners = corners_of(mesh, count);
        const TriangleBoxes boxes(mesh, first(count));
        for (const Vec3& q : queries.positions) {
            const auto expected = by_search(corners, q), found = boxes.nearest(q);
            REQUIRE(found.square == expected.square);
            REQUIRE(found.triangle == expected.triangle);
        }
    }
}

TEST_CASE("a vertex is clear of the triangles that it is no corner of, as far as was asked") {
    TriangleMesh mesh = shapes::blob(300, 1);
    const auto second_sheet = static_cast<Index>(mesh.positions.size());
    for (Index k = 0; k < 3; ++k)
        mesh.positions.push_back(1.001 * mesh.positions[mesh.triangles[5][k]]);
    mesh.triangles.push_back({second_sheet, second_sheet + 1, second_sheet + 2});
    mesh.positions.emplace_back(9, 9, 9); // a corner of nothing
    const auto corners = corners_of(mesh, mesh.triangles.size());
    const TriangleBoxes boxes(mesh, first(corners.size()));
    for (double most : {1e-6, 0.01, 0.1, std::numeric_limits<double>::infinity()}) {
        const std::vector<double> clearances = boxes.clearances(most);
        REQUIRE(clearances.size() == mesh.positions.size());
        CHECK(clearances.back() == 0);
        for (Index v = 0; v + 1 < mesh.positions.size(); ++v) {
            double square = most * most;
            for (const auto& t : corners)
                if (std::ranges::find(mesh.triangles[t.number], v) == mesh.triangles[t.number].end())
                    square = std::min(square, squared_distance_to_triangle(mesh.positions[v], t.a, t.b, t.c));
            REQUIRE(clearances[v] == doctest::Approx(std::sqrt(square)).epsilon(1e-9));
        }
    }
}

TEST_CASE(
    "of triangles that are equally close, the one that faces the query is found, whatever was known before") {
    const TriangleMesh mesh = shapes::sphere(1, 12);
    const auto corners = corners_of(mesh, mesh.triangles.size());
    const TriangleBoxes boxes(mesh, first(corners.size()));
    for (const Vec3& p : mesh.positions) { // beyond every vertex several triangles are equally close
        const Vec3 query = 1.1 * p + Vec3(1e-3, 2e-3, -1e-3);
        const auto expected = by_search(corners, query);
        CHECK(boxes.nearest(query).triangle == expected.triangle);
        for (Index likely : {Index{0}, static_cast<Index>(mesh.triangles.size() - 1)}) {
            const auto& t = corners[likely];
            const double square = squared_distance_to_triangle(query, t.a, t.b, t.c);
            CHECK(boxes.nearest(query, {likely, square}).triangle == expected.triangle);
        }
    }
}

TEST_CASE("facing decides, then the number") {
    // A ridge along y; the left side falls steeper than the right.
    const NumberedTriangle right{{0, 0, 0}, {0, 1, 0}, {1, 0, -0.5}, 4},
        left{{0, 0, 0}, {0, 1, 0}, {-1, 0, -2}, 3};
    const auto nearest = [](const Vec3& query, const NumberedTriangle& s, const NumberedTriangle& t) {
        return by_search({s, t}, query).triangle;
    };
    const Vec3 above(0.05, 0.5, 1); // as close to both: their common side is closest
    CHECK(nearest(above, left, right) == 4);
    CHECK(nearest(above, right, left) == 4);
    CHECK(nearest({-0.5, 0.2, 0.3}, left, right) == 3);
    NumberedTriangle twin = right;
    twin.number = 2;
    CHECK(nearest(above, right, twin) == 2);
}
