// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/watermark/pieces.hpp>

#include <doctest/doctest.h>
#include <wm3d/mesh/measure.hpp>
#include <wm3d/shapes/shapes.hpp>

using namespace wm3d;
using namespace wm3d::watermark;

namespace {

void append(TriangleMesh& to, const TriangleMesh& mesh, const Vec3& at) {
    const auto first = static_cast<Index>(to.positions.size());
    for (const Vec3& p : mesh.positions)
        to.positions.push_back(p + at);
    for (Triangle t : mesh.triangles) {
        for (Index& v : t)
            v += first;
        to.triangles.push_back(t);
    }
}

} // namespace

TEST_CASE("a scene falls into its models, the largest first; parts that touch are a model too") {
    TriangleMesh scene;
    append(scene, shapes::sphere(1, 20), Vec3(0, 0, 0));
    append(scene, shapes::sphere(2, 20), Vec3(10, 0, 0));
    append(scene, shapes::sphere(1, 12), Vec3(13.01, 0, 0)); // against the second
    append(scene, shapes::sphere(0.01, 4), Vec3(0, 50, 0));  // dust
    const std::vector<TriangleMesh> found = pieces(scene);
    CHECK(found.size() == 4);
    CHECK(surface_box(found[0]).max.x() == doctest::Approx(14.01));
    CHECK(surface_box(found[0]).min.x() == doctest::Approx(8));
    CHECK(surface_area(found[1]) > surface_area(found[2]));
    CHECK(found[0].positions.size() ==
          shapes::sphere(2, 20).positions.size() + shapes::sphere(1, 12).positions.size());
}

TEST_CASE("one piece is no scene, and a cloud of triangles ends") {
    CHECK(pieces(shapes::sphere(1, 8)).empty());
    CHECK(pieces({}).empty());
    TriangleMesh cloud;
    const TriangleMesh one{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
    for (int k = 0; k < 100000; ++k)
        append(cloud, one, Vec3(2.0 * k, 0, 0));
    CHECK(pieces(cloud).empty());
    const LargestParts some = largest_parts(cloud, 3000);
    CHECK(some.mesh.positions.size() == 3000);
    CHECK(some.telling == 0);
}

TEST_CASE(
    "of many parts the largest are looked at, and triangles by themselves only where there is nothing else") {
    TriangleMesh mesh;
    append(mesh, {{{0, 0, 0}, {9, 0, 0}, {0, 9, 0}}, {{0, 1, 2}}}, Vec3(0, 0, 9));
    append(mesh, shapes::sphere(1, 8), Vec3(0, 0, 0));
    append(mesh, shapes::sphere(2, 8), Vec3(10, 0, 0));
    const double single = 40.5, whole = surface_area(mesh);
    const LargestParts all = largest_parts(mesh, mesh.positions.size());
    CHECK(all.mesh.triangles == mesh.triangles);
    CHECK(all.telling == doctest::Approx(1 - single / whole));
    const LargestParts one = largest_parts(mesh, 10);
    CHECK(one.mesh.triangles.size() == shapes::sphere(2, 8).triangles.size());
    CHECK(surface_box(one.mesh).min.x() == doctest::Approx(8));
    CHECK(one.telling == doctest::Approx(surface_area(one.mesh) / whole));
    CHECK(largest_parts({}, 5).telling == 0);
}
