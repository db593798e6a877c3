// SPDX-License-Identifier: GPL-3.0-or-later
// The suspect is simplified anew: order, place, size and direction must not matter.
#include <cmath>
#include <set>

#include <doctest/doctest.h>
#include <wm3d/core/parallel.hpp>
#include <wm3d/shapes.hpp>

#include "support.hpp"

using namespace wm3d;
using namespace wm3d::simplify;
using namespace wm3d::simplify::test;

namespace {

/// Part of the numbers of `a` that `b` has too.
double overlap(const std::vector<Index>& a, const std::vector<Index>& b) {
    const std::set<Index> set(b.begin(), b.end());
    const auto common = std::ranges::count_if(a, [&](Index v) { return set.contains(v); });
    return static_cast<double>(common) / static_cast<double>(a.size());
}

const Mat3 turn =
    (Eigen::AngleAxisd(0.7, Vec3{1, 2, 3}.normalized()) * Eigen::AngleAxisd(-2.1, Vec3::UnitY()))
        .toRotationMatrix();

} // namespace

TEST_CASE("the order of the file doesn't matter") {
    for (const TriangleMesh& mesh :
         {shapes::blob(2000, 4), shapes::torus(3, 1, 40, 20), shapes::square(1, 20), moebius(40, 5),
          three_pages(9), shapes::box({1, 2, 3}, 8)}) {
        const Result expected = simplify::simplify(mesh, {.target_vertices = 100});
        for (std::uint64_t seed : {1u, 2u}) {
            const Result result = simplify::simplify(reordered(mesh, seed), {.target_vertices = 100});
            CHECK(result.mesh.positions == expected.mesh.positions);
            CHECK(result.error == expected.error);
            if (inspect_topology(mesh).non_manifold_edges ==
                0) // there, copies of a vertex follow the triangles
                CHECK(result.mesh.triangles == expected.mesh.triangles);
        }
    }
}

TEST_CASE("a scale by a power of two gives the same base vertices") {
    const TriangleMesh mesh = shapes::blob(4000, 9);
    const Result expected = simplify::simplify(mesh, {.target_vertices = 300});
    for (double scale : {0x1p-40, 0.25, 0x1p60}) {
        const Result result =
            simplify::simplify(moved(mesh, scale * Mat3::Identity(), Vec3::Zero()), {.target_vertices = 300});
        CHECK(result.original == expected.original);
        CHECK(result.error == doctest::Approx(scale * expected.error));
    }
}

TEST_CASE("a similarity transform gives nearly the same base vertices") {
    for (std::uint64_t seed : {1u, 2u, 3u}) {
        const TriangleMesh mesh = shapes::blob(20000, seed);
        const Result expected = simplify::simplify(mesh, {.target_vertices = 1000});
        const Result result =
            simplify::simplify(moved(mesh, 3.7 * turn, {10, -20, 5}), {.target_vertices = 1000});
        CHECK(overlap(result.original, expected.original) > 0.97);
    }
}

TEST_CASE("a tiny noise moves few base vertices") {
    const TriangleMesh mesh = shapes::blob(20000, 6);
    TriangleMesh noisy = mesh;
    for (std::size_t v = 0; v < noisy.positions.size(); ++v)
        for (int k = 0; k < 3; ++k)
            noisy.positions[v][k] +=
                1e-9 * std::sin(12.9898 * static_cast<double>(3 * v + static_cast<std::size_t>(k)));
    const Result expected = simplify::simplify(mesh, {.target_vertices = 1000});
    const Result result = simplify::simplify(noisy, {.target_vertices = 1000});
    CHECK(overlap(result.original, expected.original) > 0.9);
}

TEST_CASE("one thread and many give the same bytes") {
    const TriangleMesh mesh = shapes::blob(30000, 8);
    const Result many = simplify::simplify(mesh, {.target_vertices = 1500});
    const ThreadLimit one(1);
    const Result single = simplify::simplify(mesh, {.target_vertices = 1500});
    CHECK(single.original == many.original);
    CHECK(single.mesh.triangles == many.mesh.triangles);
    CHECK(single.error == many.error);
}
