// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/resync/smoothing_trend.hpp>

#include <doctest/doctest.h>

#include <wm3d/mesh/umbrella.hpp>
#include <wm3d/resync/similarity.hpp>
#include <wm3d/shapes.hpp>

using namespace wm3d;

namespace {

/// A ball with two unequal spikes, which smoothing shortens.
TriangleMesh spiky() {
    TriangleMesh mesh = shapes::sphere(1, 40);
    const Vec3 first = Vec3(1, 0.2, 0.4).normalized(), second = Vec3(-0.3, 1, 0.1).normalized();
    for (Vec3& p : mesh.positions) {
        const double a = std::max(0.0, p.dot(first) - 0.9), b = std::max(0.0, p.dot(second) - 0.95);
        p = p.cwiseProduct(Vec3(1.3, 1.1, 1)) * (1 + 12 * a + 25 * b);
    }
    return mesh;
}

double shift(const Frame& a, const Frame& b) {
    return (a.centroid - b.centroid).norm() / b.scale;
}

} // namespace

TEST_CASE("the frame before smoothing is nearer than the smoothed mesh's own") {
    const TriangleMesh mesh = spiky();
    const Frame truth = canonical_frame(mesh, Substance::solid);
    TriangleMesh smooth = mesh;
    smooth.positions = Umbrella(mesh).smooth(mesh.positions, 50, 0.1);
    const Frame own = canonical_frame(smooth, Substance::solid);
    const std::vector<resync::CandidatePose> before =
        resync::frames_before_smoothing(smooth, own, Substance::solid);
    REQUIRE(before.size() == 2);
    const double error = shift(own, truth);
    CHECK(error > 0.01);
    CHECK(shift(before.back().frame, truth) < 0.6 * error);
    CHECK(shift(before.front().frame, truth) < error);
}

TEST_CASE("a shape that smoothing leaves in place, and a dense one, give no other frame") {
    const TriangleMesh ball = shapes::sphere(1, 40);
    CHECK(resync::frames_before_smoothing(ball, canonical_frame(ball), Substance::solid).empty());
    const TriangleMesh mesh = spiky();
    resync::TrendOptions options;
    options.most_vertices = 100;
    CHECK(resync::frames_before_smoothing(mesh, canonical_frame(mesh), Substance::solid, options).empty());
}
