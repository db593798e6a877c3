// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/attack/apply.hpp>

#include <algorithm>
#include <limits>

#include <doctest/doctest.h>
#include <wm3d/attack/order.hpp>
#include <wm3d/core/error.hpp>
#include <wm3d/core/parallel.hpp>
#include <wm3d/mesh.hpp>
#include <wm3d/shapes.hpp>

#include "meshes.hpp"

using namespace wm3d;
using namespace wm3d::attack;
using namespace wm3d::attack::test;

TEST_CASE("every attack repeats with its seed, at any number of threads") {
    const TriangleMesh mesh = shapes::blob(3000, 5);
    for (const AttackInfo& info : known_attacks()) {
        if (!info.available)
            continue;
        CAPTURE(info.name);
        const AttackSpec spec = parse(info.name);
        const TriangleMesh attacked = apply(mesh, spec, 7);
        const ThreadLimit one(1);
        CHECK(same(attacked, apply(mesh, spec, 7)));
    }
    for (const char* random : {"file", "similarity", "noise", "cropping", "flips"})
        CHECK_FALSE(same(apply(mesh, parse(random), 7), apply(mesh, parse(random), 8)));
}

TEST_CASE("no attack crashes on several components and on surfaces that are no manifold") {
    const TriangleMesh two = joined(shapes::sphere(1, 8), shapes::square(1, 6), {3, 0, 0});
    for (const AttackInfo& info : known_attacks()) {
        if (!info.available)
            continue;
        CAPTURE(info.name);
        CHECK_FALSE(apply(two, parse(info.name), 1).triangles.empty());
        try {
            const TriangleMesh attacked = apply(hostile(), parse(info.name), 1);
            for (const Triangle& t : attacked.triangles)
                for (Index v : t)
                    REQUIRE(v < attacked.positions.size());
            CHECK(std::all_of(attacked.positions.begin(), attacked.positions.end(),
                              [](const Vec3& p) { return p.allFinite(); }));
        } catch (const GeometryError& error) {
            CHECK(std::string(error.what()).size() > 20);
        }
    }
}

TEST_CASE("a chain applies its attacks one after the other, each with numbers of its own") {
    const TriangleMesh mesh = shapes::blob(500, 1);
    const auto twice = parse_chain("noise:0.1+noise:0.1");
    const TriangleMesh once = apply(mesh, twice[0], 3);
    CHECK(same(apply(mesh, std::span(twice).first(1), 3), once));
    const TriangleMesh chained = apply(mesh, twice, 3);
    // the second step is not the first repeated
    CHECK((chained.positions[7] - once.positions[7] - (once.positions[7] - mesh.positions[7])).norm() > 1e-6);
    CHECK(same(apply(mesh, std::span<const AttackSpec>{}, 3), mesh));
}

TEST_CASE("what can't be attacked is refused in a sentence") {
    const TriangleMesh mesh = shapes::sphere(1, 6);
    CHECK_THROWS_AS(apply(TriangleMesh{}, parse("noise"), 1), GeometryError);
    CHECK_THROWS_AS(apply({{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}}, parse("noise"), 1),
                    GeometryError);
    TriangleMesh infinite = mesh;
    infinite.positions[3][1] = std::numeric_limits<double>::infinity();
    CHECK_THROWS_WITH_AS(apply(infinite, parse("noise"), 1), doctest::Contains("vertex 3"), GeometryError);
    CHECK_THROWS_AS(apply(mesh, AttackSpec{"noise", {}}, 1), ParameterError);
    CHECK_THROWS_AS(apply(mesh, AttackSpec{"noise", {-1}}, 1), ParameterError);
    CHECK_THROWS_WITH_AS(apply(mesh, parse("rounding:-3"), 1), doctest::Contains("leaves nothing"),
                         GeometryError);
}

TEST_CASE("seams stay closed: positions that coincide move together") {
    TriangleMesh soup; // every triangle with corners of its own
    const TriangleMesh ball = shapes::sphere(1, 6);
    for (const Triangle& t : ball.triangles) {
        const auto base = static_cast<Index>(soup.positions.size());
        for (Index v : t)
            soup.positions.push_back(ball.positions[v]);
        soup.triangles.push_back({base, base + 1, base + 2});
    }
    const TriangleMesh attacked = apply(soup, parse("noise:1"), 1);
    CHECK(attacked.positions.size() == ball.positions.size());
    CHECK(inspect_topology(attacked).boundary_edges == 0);
}

TEST_CASE("reordering keeps every triangle and its orientation") {
    const TriangleMesh mesh = shapes::blob(400, 2);
    const auto corners = [](const TriangleMesh& m) {
        std::vector<std::array<double, 9>> all;
        for (Triangle t : m.triangles) {
            std::rotate(t.begin(),
                        std::min_element(t.begin(), t.end(),
                                         [&](Index a, Index b) {
                                             return std::lexicographical_compare(
                                                 m.positions[a].begin(), m.positions[a].end(),
                                                 m.positions[b].begin(), m.positions[b].end());
                                         }),
                        t.end());
            std::array<double, 9> row{};
            for (std::size_t k = 0; k < 9; ++k)
                row[k] = m.positions[t[k / 3]][static_cast<int>(k % 3)];
            all.push_back(row);
        }
        std::sort(all.begin(), all.end());
        return all;
    };
    const TriangleMesh shuffled = reorder(mesh, 9);
    CHECK_FALSE(same(shuffled, mesh));
    CHECK(corners(shuffled) == corners(mesh));
}

TEST_CASE("rounding at a size scales the longest side to it first") {
    const TriangleMesh mesh = shapes::torus(3, 1, 30, 20);
    const TriangleMesh rounded = apply(mesh, parse("rounding:0,size=100"), 1);
    const Box box = bounding_box(rounded.positions);
    CHECK((box.max - box.min).maxCoeff() == doctest::Approx(100).epsilon(0.011)); // both ends are rounded
    for (const Vec3& p : rounded.positions)
        CHECK(p == Vec3(p.array().round()));
}
