// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/metrics/compare.hpp>

#include <cmath>

#include <doctest/doctest.h>
#include <wm3d/core.hpp>
#include <wm3d/mesh.hpp>
#include <wm3d/shapes.hpp>

using namespace wm3d;
using namespace wm3d::metrics;

namespace {

TriangleMesh scaled(TriangleMesh mesh, double factor) {
    for (Vec3& p : mesh.positions)
        p *= factor;
    return mesh;
}

} // namespace

TEST_CASE("a mesh is at distance 0 of itself") {
    const TriangleMesh mesh = shapes::blob(2000, 1);
    const Report r = compare(mesh, mesh, {10'000});
    REQUIRE(r.vertices);
    CHECK(r.vertices->rms == 0);
    CHECK(r.vertices->max == 0);
    CHECK(r.vertices->normal_rms == 0);
    CHECK(std::isinf(r.vertices->snr));
    CHECK(r.same_triangles);
    CHECK(r.percent(r.mrms) < 1e-12);
    CHECK(r.percent(r.hausdorff) < 1e-12);
    CHECK(r.normal_deviation < 1e-6);
    CHECK(r.area_change == 0);
    CHECK(r.volume_change.value() == 0);
    CHECK(r.msdm2.value() < 1e-6);
    CHECK(r.msdm2_both.value() < 1e-6);
}

TEST_CASE("a translated mesh moved by the translation, and less along its normals") {
    const TriangleMesh mesh = shapes::blob(2000, 1);
    TriangleMesh moved = mesh;
    const Vec3 step(0.003, 0, 0.004);
    for (Vec3& p : moved.positions)
        p += step;
    const VertexFigures f = compare_vertices(mesh, moved);
    CHECK(f.rms == doctest::Approx(0.005));
    CHECK(f.max == doctest::Approx(0.005));
    CHECK(f.normal_rms < 0.7 * f.rms);
    CHECK(f.normal_rms > 0.4 * f.rms);
    const Report r = compare(mesh, moved, {20'000, false});
    CHECK(r.mrms ==
          doctest::Approx(f.normal_rms).epsilon(0.05)); // to first order, surfaces move along normals
    CHECK(r.volume_change.value() == doctest::Approx(0));
    CHECK_FALSE(r.msdm2);
    CHECK_FALSE(r.msdm2_both);
}

TEST_CASE("concentric spheres: distances, volume, area, SNR") {
    const TriangleMesh ball = shapes::sphere(1, 60);
    const Report r = compare(ball, scaled(ball, 1.01), {50'000, false});
    CHECK(r.vertices->rms == doctest::Approx(0.01));
    CHECK(r.vertices->normal_rms == doctest::Approx(0.01).epsilon(1e-3));
    CHECK(r.vertices->snr == doctest::Approx(40)); // 20 log10(1 / 0.01)
    CHECK(r.mrms == doctest::Approx(0.01).epsilon(0.01));
    CHECK(r.hausdorff == doctest::Approx(0.01).epsilon(0.01));
    CHECK(r.area_change == doctest::Approx(2.01));
    CHECK(r.volume_change.value() == doctest::Approx(3.0301));
    CHECK(r.percent(r.vertices->rms) == doctest::Approx(1 / std::sqrt(12.0)).epsilon(1e-3));
}

TEST_CASE("MRMS and Hausdorff are symmetric and their percents free of scale") {
    const TriangleMesh a = shapes::blob(2000, 1), b = shapes::blob(1500, 1);
    const Report forward = compare(a, b, {20'000, false}), backward = compare(b, a, {20'000, false});
    CHECK_FALSE(forward.vertices);
    CHECK_FALSE(forward.same_triangles);
    CHECK(forward.mrms == backward.mrms);
    CHECK(forward.hausdorff == backward.hausdorff);
    CHECK(forward.mrms > 0);
    CHECK(forward.hausdorff >= forward.mrms);
    const Report large = compare(scaled(a, 1000), scaled(b, 1000), {20'000, false});
    CHECK(large.percent(large.mrms) == doctest::Approx(forward.percent(forward.mrms)).epsilon(1e-6));
}

TEST_CASE("MSDM2 is that of the second mesh against the first, and both ways beside it") {
    const TriangleMesh a = shapes::blob(2000, 1), b = shapes::blob(1500, 1);
    const Report forward = compare(a, b, {1000}), backward = compare(b, a, {1000});
    const SurfaceTree tree(a);
    CHECK(*forward.msdm2 == Msdm2(tree).distance(b));
    CHECK(*forward.msdm2 != *backward.msdm2);
    CHECK(*forward.msdm2_both == (*forward.msdm2 + *backward.msdm2) / 2);
    CHECK(*backward.msdm2_both == doctest::Approx(*forward.msdm2_both).epsilon(1e-12));
}

TEST_CASE("a part that is missing shows in one direction only") {
    const TriangleMesh whole = shapes::square(1, 10);
    TriangleMesh part = whole;
    part.triangles.resize(part.triangles.size() / 2);
    const Report r = compare(whole, part, {10'000, false});
    CHECK(r.backward.max < 1e-12);
    CHECK(r.forward.max == doctest::Approx(0.5));
    CHECK(r.hausdorff == r.forward.max);
    CHECK_FALSE(r.volume_change);
}

TEST_CASE("what can't be compared is refused") {
    const TriangleMesh ball = shapes::sphere(1, 6);
    CHECK_THROWS_AS(compare(ball, TriangleMesh{}), GeometryError);
    CHECK_THROWS_AS(compare(ball, ball, {0}), ParameterError);
}
