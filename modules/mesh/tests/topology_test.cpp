// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/mesh/topology.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <numeric>
#include <span>
#include <utility>
#include <vector>

#include <doctest/doctest.h>

#include <wm3d/mesh/measure.hpp>
#include <wm3d/mesh/sides.hpp>

using namespace wm3d;

namespace {

TriangleMesh tetrahedron() {
    return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}}, {{0, 2, 1}, {0, 1, 3}, {0, 3, 2}, {1, 2, 3}}};
}

/// Between a circle of 24 vertices and another, `height` above it.
TriangleMesh strip(double radius, double upper_radius, double height) {
    constexpr Index n = 24;
    TriangleMesh mesh;
    for (const bool upper : {false, true})
        for (Index k = 0; k < n; ++k) {
            const double r = upper ? upper_radius : radius, angle = 2 * std::numbers::pi * k / n;
            mesh.positions.emplace_back(r * std::cos(angle), r * std::sin(angle), upper ? height : 0);
        }
    for (Index k = 0; k < n; ++k) {
        const Index next = (k + 1) % n;
        mesh.triangles.push_back({k, next, n + next});
        mesh.triangles.push_back({k, n + next, n + k});
    }
    return mesh;
}

} // namespace

TEST_CASE("a tetrahedron is one closed part of Euler characteristic 2") {
    const Topology t = inspect_topology(tetrahedron());
    CHECK(t.components == 1);
    CHECK(t.edges == 6);
    CHECK(t.euler_characteristic == 2);
    CHECK(t.closed());
    CHECK(t.boundary_loops == 0);
    CHECK(t.degenerate_triangles == 0);
    CHECK(enclosed_volume(tetrahedron()) == doctest::Approx(1.0 / 6).epsilon(1e-14));
}

TEST_CASE("the volume doesn't depend on where the mesh lies") {
    TriangleMesh mesh = tetrahedron();
    for (Vec3& p : mesh.positions)
        p += Vec3(1e6, -2e6, 3e6);
    CHECK(enclosed_volume(mesh) == doctest::Approx(1.0 / 6).epsilon(1e-12));
}

TEST_CASE("a missing triangle leaves a boundary loop") {
    TriangleMesh mesh = tetrahedron();
    mesh.triangles.pop_back();
    const Topology t = inspect_topology(mesh);
    CHECK(t.boundary_edges == 3);
    CHECK(t.boundary_loops == 1);
    CHECK(t.euler_characteristic == 1);
    CHECK_FALSE(t.closed());
}

TEST_CASE("a turned triangle is misoriented along its three edges") {
    TriangleMesh mesh = tetrahedron();
    std::swap(mesh.triangles[0][0], mesh.triangles[0][1]);
    CHECK(inspect_topology(mesh).misoriented_edges == 3);
    CHECK_FALSE(inspect_topology(mesh).closed());
}

TEST_CASE("parts, isolated vertices, fins and degenerate triangles are counted") {
    TriangleMesh mesh = tetrahedron();
    const TriangleMesh other = tetrahedron();
    for (const Vec3& p : other.positions)
        mesh.positions.push_back(p + Vec3(5, 0, 0));
    for (const Triangle& t : other.triangles)
        mesh.triangles.push_back({t[0] + 4, t[1] + 4, t[2] + 4});
    mesh.positions.push_back({9, 9, 9});
    mesh.positions.push_back({0, -1, 0});
    mesh.triangles.push_back({0, 1, 9}); // a fin on an edge that has two triangles already
    mesh.triangles.push_back({4, 4, 5});
    const Topology t = inspect_topology(mesh);
    CHECK(t.components == 2);
    CHECK(t.isolated_vertices == 1);
    CHECK(t.non_manifold_edges >= 1);
    CHECK(t.boundary_edges == 2);
    CHECK(t.boundary_loops == 1);
    CHECK(t.degenerate_triangles == 1);
}

TEST_CASE("nothing has no parts") {
    const Topology t = inspect_topology({});
    CHECK(t.components == 0);
    CHECK(t.euler_characteristic == 0);
    CHECK(enclosed_volume({}) == 0);
}

TEST_CASE("the opening of a border is the area vector that is missing") {
    TriangleMesh mesh = tetrahedron();
    const Vec3 missing = 0.5 * area_vector(mesh, 3);
    mesh.triangles.pop_back();
    for (Vec3& p : mesh.positions)
        p += Vec3(100, 200, -300);
    const std::vector<BorderLoop> loops = border_loops(mesh);
    REQUIRE(loops.size() == 1);
    CHECK(loops[0].edges == 3);
    CHECK(loops[0].length == doctest::Approx(3 * std::sqrt(2.0)));
    CHECK((loops[0].opening - missing).norm() < 1e-10);
    CHECK((loops[0].centre - Vec3(100, 200, -300) - Vec3::Constant(1 / 3.0)).norm() < 1e-10);
    CHECK(border_loops(tetrahedron()).empty());
}

TEST_CASE("the rim of a hole is flat, that of a tube's end is not") {
    const std::vector<BorderLoop> tube = border_loops(strip(1, 1, 1)), ring = border_loops(strip(2, 1, 0));
    REQUIRE(tube.size() == 2);
    for (const BorderLoop& end : tube)
        CHECK(std::abs(end.flatness()) < 1e-12);
    REQUIRE(ring.size() == 2);
    CHECK(ring[0].flatness() == doctest::Approx(-1)); // the outline: what closes it lies on the back
    CHECK(ring[1].flatness() == doctest::Approx(1));  // the hole
}

TEST_CASE("a crack is a border that opens nothing, and every part has borders of its own") {
    // Two strips side by side that share positions along a line but no vertices.
    const TriangleMesh crack{
        {{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {1, 0, 0}, {2, 0, 0}, {2, 1, 0}, {1, 1, 0}},
        {{0, 1, 2}, {0, 2, 3}, {4, 5, 6}, {4, 6, 7}}};
    const std::vector<BorderLoop> loops = border_loops(crack);
    REQUIRE(loops.size() == 2);
    CHECK(loops[0].opening.z() == doctest::Approx(-1));
    CHECK(loops[1].opening.z() == doctest::Approx(-1));

    const TriangleMesh slit{{{0, 0, 0}, {2, 0, 0}, {0, 2, 0}, {0, -2, 0}, {1, 0, 0}, {1, 0, 0}, {-1, 0, 0}},
                            {{0, 4, 2}, {4, 1, 2}, {0, 3, 5}, {5, 3, 1}, {0, 2, 6}, {0, 6, 3}}};
    double openings = 0;
    for (const BorderLoop& loop : border_loops(slit))
        openings += loop.opening.norm();
    CHECK(openings ==
          doctest::Approx(surface_area(slit))); // the outline alone, though the slit is a border too
}

TEST_CASE("sides of some lower ends are those of all, one after the other") {
    const TriangleMesh mesh = strip(1, 0.5, 1);
    const auto told = [](const std::vector<Side>& sides) {
        std::vector<std::array<Index, 4>> list;
        for (const Side& s : sides)
            list.push_back({s.low, s.high, s.forward ? 1u : 0u, s.triangle});
        return list;
    };
    REQUIRE(mesh.positions.size() == 48);
    std::vector<Index> all(48);
    std::iota(all.begin(), all.end(), Index{0});
    std::vector<Side> parts;
    for (const auto& [begin, end] : {std::pair<std::size_t, std::size_t>{0, 0}, {0, 17}, {17, 48}}) {
        const std::vector<Side> part = sorted_sides(mesh, std::span(all).subspan(begin, end - begin));
        parts.insert(parts.end(), part.begin(), part.end());
    }
    CHECK(told(parts) == told(sorted_sides(mesh)));
    CHECK(parts.size() == 3 * mesh.triangles.size());

    const std::vector<Index> some{3, 4, 30};
    std::erase_if(parts, [&](const Side& s) { return std::ranges::find(some, s.low) == some.end(); });
    CHECK(!parts.empty());
    CHECK(told(parts) == told(sorted_sides(mesh, some)));
}

TEST_CASE("the border of a torn mesh is found among edges that aren't walked once either way") {
    // A quadrilateral whose second triangle faces the other way, and a third triangle on its diagonal.
    const TriangleMesh mesh{{{0, 0, 0}, {1, 0, 0}, {1, 1, 0}, {0, 1, 0}, {0, 0, 1}},
                            {{0, 1, 2}, {0, 3, 2}, {0, 2, 4}}};
    const std::vector<BorderLoop> loops = border_loops(mesh);
    REQUIRE(loops.size() == 1);
    CHECK(loops[0].edges == 6); // all but the diagonal, on which three sides lie
}
