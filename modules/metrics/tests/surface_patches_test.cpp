// SPDX-License-Identifier: GPL-3.0-or-later
#include "../src/surface_patches.hpp"

#include <algorithm>
#include <numeric>

#include <doctest/doctest.h>
#include <wm3d/mesh.hpp>
#include <wm3d/shapes.hpp>

using namespace wm3d;
using namespace wm3d::metrics;

TEST_CASE("a patch has the triangles that meet its box, in their order") {
    const TriangleMesh mesh = along_curve(shapes::blob(5000, 1)).mesh;
    const Box box{mesh.positions[700] - Vec3::Constant(0.2), mesh.positions[700] + Vec3::Constant(0.2)};
    SurfacePatch patch;
    SurfacePatches(mesh).take(box, patch);
    std::vector<Triangle> expected;
    for (const Triangle& t : mesh.triangles) {
        const Box own =
            bounding_box(std::vector{mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]]});
        if ((own.min.array() <= box.max.array()).all() && (box.min.array() <= own.max.array()).all())
            expected.push_back(t);
    }
    REQUIRE(expected.size() > 10);
    REQUIRE(expected.size() < mesh.triangles.size());
    REQUIRE(patch.mesh.triangles.size() == expected.size());
    CHECK(std::ranges::is_sorted(patch.vertices));
    for (std::size_t f = 0; f < expected.size(); ++f)
        for (std::size_t k = 0; k < 3; ++k)
            CHECK(patch.vertices[patch.mesh.triangles[f][k]] == expected[f][k]);
    for (Index v = 0; v < patch.vertices.size(); ++v) {
        CHECK(patch.mesh.positions[v] == mesh.positions[patch.vertices[v]]);
        CHECK(patch.local(patch.vertices[v]) == v);
    }
}

TEST_CASE("groups hold every vertex once, each group in a cell's size") {
    const TriangleMesh mesh = shapes::blob(3000, 1);
    std::vector<Index> vertices(mesh.positions.size());
    std::iota(vertices.begin(), vertices.end(), Index{0});
    const std::vector<VertexGroup> groups = groups_of(mesh, vertices, 2);
    const Box all = surface_box(mesh);
    std::vector<Index> met;
    for (const VertexGroup& group : groups) {
        CHECK((group.box.max - group.box.min).maxCoeff() <= (all.max - all.min).maxCoeff() / 4 * (1 + 1e-9));
        CHECK(std::ranges::is_sorted(group.vertices));
        met.insert(met.end(), group.vertices.begin(), group.vertices.end());
    }
    CHECK(groups.size() > 8);
    std::ranges::sort(met);
    CHECK(met == vertices);
}
