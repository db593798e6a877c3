// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/metrics/msdm2_patches.hpp>

#include <cmath>
#include <numeric>

#include <doctest/doctest.h>
#include <wm3d/core.hpp>
#include <wm3d/mesh.hpp>
#include <wm3d/metrics/surface_tree.hpp>
#include <wm3d/shapes.hpp>

using namespace wm3d;
using namespace wm3d::metrics;

namespace {

/// A blob and the same with waves along its normals that are some hundredths of it long.
struct Pair {
    TriangleMesh mesh;
    std::vector<Vec3> moved;
};

Pair wavy_pair(std::size_t vertices, double height) {
    Pair pair{along_curve(shapes::blob(vertices, 1)).mesh, {}};
    const std::vector<Vec3> normals = vertex_normals(pair.mesh);
    for (std::size_t v = 0; v < normals.size(); ++v) {
        const Vec3& p = pair.mesh.positions[v];
        const double wave = std::sin(40 * p.x()) * std::sin(43 * p.y()) * std::sin(37 * p.z());
        pair.moved.emplace_back(p + height * wave * normals[v]);
    }
    return pair;
}

} // namespace

TEST_CASE("patches tell what the whole tells where every vertex counts") {
    const Pair pair = wavy_pair(20000, 1e-3);
    const SurfaceTree tree(pair.mesh);
    const Msdm2 whole(tree);
    const Msdm2Patches patches(pair.mesh);
    REQUIRE(patches.stride() == 1);
    for (const std::size_t windows : {300, 4000}) {
        const Msdm2Sample expected = whole.sample({pair.moved, pair.mesh.triangles}, windows);
        const Msdm2Sample seen = patches.sample(pair.moved, windows);
        CHECK(seen.mean > 0.01);
        CHECK(seen.mean == doctest::Approx(expected.mean).epsilon(1e-5));
        REQUIRE(seen.vertices == expected.vertices);
        for (std::size_t i = 0; i < seen.local.size(); ++i) // of few vertices another point is the closest
            CHECK(seen.local[i] == doctest::Approx(expected.local[i]).epsilon(1e-3));
        const Msdm2Sample again =
            patches.at(pair.moved, expected.vertices); // what is known by now serves too
        CHECK(again.local == seen.local);
    }
    for (const Index step : {67, 5}) {
        std::vector<Index> vertices;
        for (Index v = 0; v < pair.moved.size(); v += step)
            vertices.push_back(v);
        const Msdm2Sample expected = whole.at({pair.moved, pair.mesh.triangles}, vertices);
        const Msdm2Sample seen = patches.at(pair.moved, vertices);
        CHECK(seen.mean == doctest::Approx(expected.mean).epsilon(1e-5));
        for (std::size_t i = 0; i < seen.local.size(); ++i)
            CHECK(seen.local[i] == doctest::Approx(expected.local[i]).epsilon(1e-4));
    }
}

TEST_CASE("where some vertices stand for all, the mean is the same within a hundredth") {
    const Pair pair = wavy_pair(60000, 1e-3);
    const Msdm2Patches patches(pair.mesh);
    REQUIRE(patches.stride() == 1);
    REQUIRE(patches.stride(10) > 1);
    const double expected = patches.sample(pair.moved, 3000).mean;
    CHECK(patches.sample(pair.moved, 3000, 10).mean == doctest::Approx(expected).epsilon(0.01));
}

TEST_CASE("patches tell the same bytes at any number of threads, and of edges longer than a window") {
    const auto on = [](const Pair& pair, std::size_t threads) {
        const ThreadLimit limit(threads);
        const Msdm2Patches patches(pair.mesh);
        std::vector<double> local = patches.sample(pair.moved, 500).local;
        const std::vector<double> more = patches.sample(pair.moved, 5000).local;
        local.insert(local.end(), more.begin(), more.end());
        return local;
    };
    for (const std::size_t vertices : {300, 9000}) {
        const Pair pair = wavy_pair(vertices, 1e-3);
        CHECK(on(pair, 1) == on(pair, 7));
    }
}

TEST_CASE("a mesh without a triangle has no MSDM2, and parts without area show nothing") {
    const TriangleMesh points{{Vec3::Zero(), Vec3::UnitX()}, {}};
    CHECK_THROWS_AS(Msdm2Patches{points}, GeometryError);
    TriangleMesh mesh = shapes::blob(500, 1);
    const auto far = static_cast<Index>(mesh.positions.size());
    for (int i = 0; i < 3; ++i)
        mesh.positions.emplace_back(10 + i, 0, 0);
    mesh.triangles.push_back({far, far + 1, far + 2}); // a line
    CHECK(Msdm2Patches(mesh).at(mesh.positions, {far}).local.front() == 0);
}
