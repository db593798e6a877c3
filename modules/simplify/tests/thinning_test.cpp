// SPDX-License-Identifier: GPL-3.0-or-later
#include "../src/thinning.hpp"

#include <algorithm>

#include <doctest/doctest.h>
#include <wm3d/core/parallel.hpp>
#include <wm3d/shapes.hpp>

#include "support.hpp"

using namespace wm3d;
using namespace wm3d::simplify;
using namespace wm3d::simplify::test;

namespace {

constexpr std::size_t small_block = 1000;

TriangleMesh thinned(const TriangleMesh& mesh, std::size_t target, Thinning* what = nullptr) {
    Canonical input = canonical_order(mesh);
    const Thinning thinning = thin(input, {.target_vertices = target}, small_block);
    if (what != nullptr)
        *what = thinning;
    return {input.positions, input.triangles};
}

/// Vertices less edges plus triangles.
std::ptrdiff_t euler(const TriangleMesh& mesh, const Topology& topology) {
    return static_cast<std::ptrdiff_t>(mesh.positions.size()) - static_cast<std::ptrdiff_t>(topology.edges) +
           static_cast<std::ptrdiff_t>(mesh.triangles.size());
}

} // namespace

TEST_CASE("thinning keeps the topology, and enough vertices for the target") {
    for (const TriangleMesh& mesh :
         {shapes::blob(20000, 3), shapes::torus(1, 0.4, 200, 80),
          joined(shapes::sphere(1, 80), moved(shapes::blob(8000, 1), Mat3::Identity(), Vec3(5, 0, 0)))}) {
        Thinning what;
        const TriangleMesh sparse = thinned(mesh, 500, &what);
        CHECK(sparse.positions.size() + what.removed == mesh.positions.size());
        CHECK(sparse.positions.size() >= 1000);
        CHECK(what.removed > mesh.positions.size() / 2);
        CHECK(what.largest_error > 0);
        const Topology before = inspect_topology(mesh), after = inspect_topology(sparse);
        CHECK(after.components == before.components);
        CHECK(after.closed());
        CHECK(euler(sparse, after) == euler(mesh, before));
    }
}

TEST_CASE("large blocks leave little more than the target, and stand for all that went") {
    const TriangleMesh mesh = shapes::blob(60000, 3);
    const Options options{.target_vertices = 2000};
    Canonical input = canonical_order(mesh);
    Thinning what = thin(input, options, small_block);
    const std::size_t before = input.positions.size();
    thin_further(input, options, what);
    CHECK(input.positions.size() + what.removed == mesh.positions.size());
    CHECK(input.positions.size() < before * 3 / 4);
    CHECK(input.positions.size() > options.target_vertices);
    CHECK(std::ranges::is_sorted(what.standing, {}, &Standing::vertex));
    CHECK(what.standing.size() > input.positions.size() / 2); // but of small blocks that stayed as they were
    CHECK(what.standing.back().vertex < input.positions.size());
    const Topology after = inspect_topology({input.positions, input.triangles});
    CHECK(after.components == 1);
    CHECK(after.closed());
}

TEST_CASE("blocks where the surface turns most keep most") {
    const TriangleMesh flat = shapes::box({1, 1, 1}, 60); // all its need is at creases
    const TriangleMesh mesh =
        joined(flat, moved(shapes::blob(flat.positions.size(), 1), Mat3::Identity(), Vec3(3, 0, 0)));
    const TriangleMesh sparse = thinned(mesh, 800);
    const double middle = (surface_box(sparse).min.x() + surface_box(sparse).max.x()) / 2;
    const auto of_box =
        std::ranges::count_if(sparse.positions, [&](const Vec3& p) { return p.x() < middle - 0.1; });
    CHECK(static_cast<std::size_t>(of_box) < sparse.positions.size() / 2);
}

TEST_CASE("a dense mesh is simplified as well in blocks as at once, whatever its order") {
    const TriangleMesh mesh = shapes::blob(250'000, 2);
    const Result at_once = simplify::simplify(mesh, {.target_vertices = 3000, .thinned_from = 1'000'000});
    const Result in_blocks = simplify::simplify(mesh, {.target_vertices = 3000});
    CHECK(in_blocks.stop == Stop::reached);
    CHECK(in_blocks.mesh.positions.size() == 3000);
    CHECK(in_blocks.collapses == mesh.positions.size() - 3000);
    CHECK(inspect_topology(in_blocks.mesh).closed());
    CHECK(std::abs(enclosed_volume(in_blocks.mesh) - enclosed_volume(at_once.mesh)) <
          1e-4 * enclosed_volume(mesh));
    CHECK(in_blocks.error < 1.2 * at_once.error);
    for (std::size_t i = 0; i < in_blocks.original.size(); i += 7)
        CHECK(in_blocks.mesh.positions[i] == mesh.positions[in_blocks.original[i]]);
    const ThreadLimit limit(1);
    const Result again = simplify::simplify(reordered(mesh, 5), {.target_vertices = 3000});
    CHECK(again.mesh.positions == in_blocks.mesh.positions);
    CHECK(again.mesh.triangles == in_blocks.mesh.triangles);
}

TEST_CASE("blocks that are no manifolds stay, and what is open stays open") {
    TriangleMesh mesh =
        joined(shapes::blob(20000, 3), moved(moebius(400, 6), Mat3::Identity(), Vec3(5, 0, 0)));
    const auto edge = mesh.triangles.front(); // gets a third triangle
    mesh.triangles.push_back({edge[0], edge[1], static_cast<Index>(mesh.positions.size() - 1)});
    Thinning what;
    const TriangleMesh sparse = thinned(mesh, 500, &what);
    CHECK(what.removed > 10000);
    const Topology before = inspect_topology(mesh), after = inspect_topology(sparse);
    CHECK(after.components == before.components);
    CHECK(after.boundary_loops == before.boundary_loops);
    CHECK(after.non_manifold_edges == before.non_manifold_edges);
    CHECK(euler(sparse, after) == euler(mesh, before));
}
