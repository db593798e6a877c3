// SPDX-License-Identifier: GPL-3.0-or-later
// What no simplification may change: parts, handles, holes, sides.
#include <set>

#include <doctest/doctest.h>
#include <wm3d/shapes.hpp>

#include "support.hpp"

using namespace wm3d;
using namespace wm3d::simplify;
using namespace wm3d::simplify::test;

namespace {

void check_same_topology(const TriangleMesh& before, const TriangleMesh& after) {
    const Topology a = inspect_topology(before), b = inspect_topology(after);
    CHECK(b.euler_characteristic == a.euler_characteristic);
    CHECK(b.components == a.components);
    CHECK(b.boundary_loops == a.boundary_loops);
    CHECK(b.non_manifold_edges == 0);
    CHECK(b.misoriented_edges == 0);
    CHECK(b.isolated_vertices == 0);
    CHECK(b.degenerate_triangles == 0);
}

TriangleMesh cylinder(std::size_t around, std::size_t high) {
    TriangleMesh mesh = shapes::torus(3, 1, around, high + 1);
    std::erase_if(mesh.triangles, [&](const Triangle& t) { // cut the tube open lengthwise
        return std::ranges::any_of(t, [&](Index v) { return v % (high + 1) == 0; });
    });
    return mesh;
}

} // namespace

TEST_CASE("parts, handles and boundary loops stay at every size") {
    const std::vector<TriangleMesh> meshes{
        shapes::box({1, 1, 1}, 6), shapes::torus(3, 1, 30, 20),
        shapes::blob(1500, 3),     shapes::square(2, 15),
        cylinder(30, 12),          joined(shapes::sphere(1, 10), shapes::torus(5, 1, 20, 10))};
    for (const TriangleMesh& mesh : meshes)
        for (std::size_t target : {400u, 150u, 60u, 20u, 0u}) {
            CAPTURE(target);
            const Result result = simplify::simplify(mesh, {.target_vertices = target});
            check_same_topology(mesh, result.mesh);
            if (result.stop == Stop::reached)
                CHECK(result.mesh.positions.size() == target);
        }
}

TEST_CASE("boundary vertices move along the boundary only") {
    const TriangleMesh mesh = shapes::square(1, 20);
    const Result result = simplify::simplify(mesh, {.target_vertices = 10});
    double area = surface_area(result.mesh);
    CHECK(area == doctest::Approx(1).epsilon(1e-12)); // the corners stay, so does the outline
    for (std::size_t f = 0; f < result.mesh.triangles.size(); ++f)
        CHECK(area_vector(result.mesh, f)[2] > 0);
}

TEST_CASE("a lone triangle and a tetrahedron can't shrink") {
    TriangleMesh triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
    CHECK(simplify::simplify(triangle, {.target_vertices = 2}).stop == Stop::blocked);
    TriangleMesh tetrahedron{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}},
                             {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {0, 3, 2}}};
    const Result result = simplify::simplify(tetrahedron, {.target_vertices = 3});
    CHECK(result.stop == Stop::blocked);
    CHECK(result.mesh.triangles.size() == 4);
    TriangleMesh two{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 1, 0}}, {{0, 1, 2}, {1, 3, 2}}};
    const Result cut = simplify::simplify(two, {.target_vertices = 1, .max_normal_turn = 90});
    CHECK(cut.stop == Stop::blocked);
    CHECK(cut.mesh.triangles.size() == 1);
}

TEST_CASE("a Moebius strip stays a Moebius strip") {
    const TriangleMesh strip = moebius(60, 6);
    const Result result = simplify::simplify(strip, {.target_vertices = 60});
    CHECK(result.stop == Stop::reached);
    const Topology topology = inspect_topology(result.mesh);
    CHECK(topology.euler_characteristic == 0);
    CHECK(topology.boundary_loops == 1);
    CHECK(topology.misoriented_edges > 0); // no choice of sides avoids it
    CHECK(topology.non_manifold_edges == 0);
}

TEST_CASE("where three sheets meet nothing is removed") {
    constexpr std::size_t n = 12;
    const TriangleMesh book = three_pages(n);
    const Result result = simplify::simplify(book, {.target_vertices = 40});
    const std::set<Index> kept(result.original.begin(), result.original.end());
    for (Index spine = 0; spine <= n; ++spine)
        CHECK(kept.contains(spine));
    CHECK(result.stop == Stop::reached);
    CHECK(inspect_topology(result.mesh).non_manifold_edges == n);
    CHECK(inspect_topology(result.mesh).components == 1);
    CHECK(surface_area(result.mesh) == doctest::Approx(surface_area(book)).epsilon(1e-12));
}

TEST_CASE("two closed surfaces that share a vertex keep it") {
    TriangleMesh pair = joined(shapes::sphere(1, 10), shapes::sphere(1, 10));
    const auto shared = static_cast<Index>(pair.positions.size() / 2); // north pole of the second
    for (std::size_t v = shared; v < pair.positions.size(); ++v)
        pair.positions[v] -= Vec3{0, 0, 2};
    const Index south = shared - 1;
    for (Triangle& t : pair.triangles)
        std::ranges::replace(t, shared, south);
    const Result result = simplify::simplify(pair, {.target_vertices = 30});
    CHECK(result.stop == Stop::reached);
    CHECK(std::ranges::count(result.original, south) == 1);
    CHECK(std::ranges::count(result.original, shared) == 0); // isolated now
    const Topology topology = inspect_topology(result.mesh);
    CHECK(topology.components == 1);
    CHECK(topology.euler_characteristic == 3);
    CHECK(topology.closed());
}

TEST_CASE("a tetrahedron that hangs on one edge is not flattened") {
    // Simplifiers leave such spikes. The edge has four triangles, so it is cut open and its ends stay, but
    // the two other corners may not vanish one after the other.
    for (std::uint64_t seed = 1; seed <= 6; ++seed) {
        TriangleMesh mesh = shapes::blob(600, seed);
        const auto spikes = static_cast<Index>(mesh.triangles.size() / 40);
        for (Index s = 0; s < spikes; ++s) {
            const Triangle t = mesh.triangles[40 * s];
            const auto c = static_cast<Index>(mesh.positions.size()), d = c + 1;
            const Vec3 a = mesh.positions[t[0]], b = mesh.positions[t[1]],
                       out = area_vector(mesh, 40 * s).normalized();
            mesh.positions.push_back((a + b) / 2 + 0.02 * out);
            mesh.positions.push_back((2 * a + b) / 3 + 0.03 * out);
            for (const Triangle& face : {Triangle{t[0], t[1], c}, Triangle{t[1], t[0], d},
                                         Triangle{c, d, t[0]}, Triangle{d, c, t[1]}})
                mesh.triangles.push_back(face);
        }
        for (std::size_t target : {500u, 300u, 100u, 0u}) {
            const Result result = simplify::simplify(mesh, {.target_vertices = target});
            std::set<std::set<Index>> faces;
            for (const Triangle& t : result.mesh.triangles) {
                REQUIRE(std::ranges::max(t) < result.mesh.positions.size());
                CHECK(faces.insert({t.begin(), t.end()}).second);
            }
            CHECK(inspect_topology(result.mesh).degenerate_triangles == 0);
        }
    }
}
