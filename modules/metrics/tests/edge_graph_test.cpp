// SPDX-License-Identifier: GPL-3.0-or-later
#include "../src/edge_graph.hpp"

#include <cmath>
#include <numbers>
#include <set>

#include <doctest/doctest.h>
#include <wm3d/mesh/neighbours.hpp>
#include <wm3d/shapes.hpp>

#include "../src/outward_walk.hpp"

using namespace wm3d;
using namespace wm3d::metrics;

TEST_CASE("the edges are those of the mesh, and lead where its neighbours are") {
    for (const TriangleMesh& mesh : {shapes::blob(500, 1), shapes::square(1, 5), shapes::box({1, 2, 3}, 2)}) {
        const EdgeGraph graph(mesh);
        const std::vector<wm3d::Edge> expected = edges_of(mesh);
        REQUIRE(graph.edges().size() == expected.size());
        for (std::size_t e = 0; e < expected.size(); ++e) {
            CHECK(graph.edges()[e].a == expected[e].a);
            CHECK(graph.edges()[e].b == expected[e].b);
            CHECK((graph.edges()[e].left != no_index) == (expected[e].faces == 2));
        }
        const Neighbours neighbours(mesh);
        for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
            std::vector<Index> ends;
            for (const EdgeGraph::Way& way : graph.ways_from(v))
                ends.push_back(way.to);
            CHECK(std::ranges::equal(ends, neighbours.of(v)));
        }
    }
}

namespace {

/// Angles at every edge, #E.
std::vector<double> angles(const TriangleMesh& mesh) {
    std::vector<double> angles;
    for (const Bend& bend : bends_of(mesh, EdgeGraph(mesh)))
        angles.push_back(bend.angle_per_length == 0 ? 0 : bend.angle_per_length / bend.per_length);
    return angles;
}

} // namespace

TEST_CASE("an edge between triangles that disagree, or of three triangles, turns nowhere") {
    const std::vector<Vec3> points{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}};
    const TriangleMesh fold{points, {{0, 1, 2}, {1, 0, 3}}}, disagreeing{points, {{0, 1, 2}, {0, 1, 3}}},
        fan{points, {{0, 1, 2}, {1, 0, 3}, {1, 0, 4}}};
    const auto angle_of_first = [](const TriangleMesh& mesh) { return angles(mesh).front(); };
    CHECK(std::abs(angle_of_first(fold)) == doctest::Approx(std::numbers::pi / 2));
    CHECK(angle_of_first(disagreeing) == 0);
    CHECK(angle_of_first(fan) == 0);
}

TEST_CASE("edges turn with the sign of the surface, and more than a right angle counts as its supplement") {
    const TriangleMesh box = shapes::box({1, 1, 1}, 1);
    for (double angle : angles(box))
        CHECK((std::abs(angle) < 1e-12 || std::abs(angle - std::numbers::pi / 2) < 1e-12));
    for (double turn : {30.0, 100.0, 170.0}) {
        const double t = turn * std::numbers::pi / 180;
        const TriangleMesh ridge{{{0, 0, 0}, {1, 0, 0}, {0, std::cos(t), -std::sin(t)}, {0, -1, 0}},
                                 {{1, 0, 2}, {0, 1, 3}}};
        const double expected = std::min(turn, 180 - turn) * std::numbers::pi / 180;
        CHECK(std::abs(angles(ridge).front()) == doctest::Approx(expected));
    }
}

namespace {

/// What a walk from `centre` reaches, the centre included, by going over all edges until nothing is new.
std::set<Index> reached_by_search(const TriangleMesh& mesh, Index centre, double radius) {
    std::set<Index> reached{centre};
    const auto follow = [&](Index from, Index to) {
        const Vec3 start = mesh.positions[from] - mesh.positions[centre];
        const Vec3 end = mesh.positions[to] - mesh.positions[centre];
        if (reached.contains(from) && end.norm() <= radius &&
            (from == centre || (end - start).dot(start) > 0))
            reached.insert(to);
    };
    for (std::size_t before = 0; before != reached.size();) {
        before = reached.size();
        for (const wm3d::Edge& e : edges_of(mesh)) {
            follow(e.a, e.b);
            follow(e.b, e.a);
        }
    }
    return reached;
}

} // namespace

TEST_CASE(
    "a walk outwards reaches what leads away from its centre within its sphere, and takes no edge twice") {
    const TriangleMesh mesh = shapes::blob(400, 1);
    const EdgeGraph graph(mesh);
    OutwardWalk walk(mesh, graph);
    for (Index centre : {Index{0}, Index{57}, Index{200}, Index{340}})
        for (double radius : {0.01, 0.3, 0.7, 5.0}) {
            std::set<Index> reached{centre}, edges;
            walk.from(centre, radius);
            CHECK(walk.reached()[0].vertex == centre);
            for (const OutwardWalk::Reached& r : walk.reached().subspan(1)) {
                CHECK(reached.insert(r.vertex).second);
                CHECK(r.square == (mesh.positions[r.vertex] - mesh.positions[centre]).squaredNorm());
            }
            for (const OutwardWalk::Step& s : walk.steps()) {
                const OutwardWalk::Reached& start = walk.reached()[s.reached];
                CHECK(reached.contains(start.vertex));
                CHECK(edges.insert(s.edge).second);
                CHECK(s.to_square > start.square);
                CHECK(s.outward == start.place.dot(s.along));
                CHECK((start.place + s.along - mesh.positions[s.to] + mesh.positions[centre]).norm() < 1e-12);
            }
            CHECK(reached == reached_by_search(mesh, centre, radius));
        }
}

TEST_CASE("a walk doesn't turn at right angles") {
    const TriangleMesh flat = shapes::square(10, 10); // 11 by 11 vertices, 1 apart
    const EdgeGraph graph(flat);
    OutwardWalk walk(flat, graph);
    walk.from(60, 1.5);
    CHECK(walk.reached().size() == 7); // with the centre; not the corners to which no diagonal leads
}

TEST_CASE("an edge leaves a sphere where it crosses it") {
    OutwardWalk::Reached start;
    start.place = Vec3(1, 0, 0);
    start.square = 1;
    OutwardWalk::Step s;
    s.along = Vec3(2, 0, 0);
    s.outward = 2;
    s.to_square = 9;
    CHECK(start.is_within(1));
    CHECK_FALSE(start.is_within(0.9));
    CHECK(s.share_within(2, start) == doctest::Approx(0.5));
    CHECK(s.share_within(3, start) == 1);
    CHECK(s.share_within(1, start) == 0);
}
