// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/metrics/surface_distance.hpp>

#include <cmath>
#include <numbers>

#include <doctest/doctest.h>
#include <wm3d/core.hpp>
#include <wm3d/mesh.hpp>
#include <wm3d/shapes.hpp>

using namespace wm3d;
using namespace wm3d::metrics;

TEST_CASE("parallel squares are their gap apart") {
    const TriangleMesh low = shapes::square(2, 7);
    TriangleMesh high = shapes::square(2, 3);
    for (Vec3& p : high.positions)
        p[2] = 0.25;
    const SurfaceTree tree(high);
    const OneSidedDistance d = surface_distance(low, tree, 1000);
    CHECK(d.mean == doctest::Approx(0.25));
    CHECK(d.rms == doctest::Approx(0.25));
    CHECK(d.max == doctest::Approx(0.25));
    CHECK(d.normal_deviation == doctest::Approx(0));
    CHECK(d.samples >= 1000);
    CHECK(d.spacing == doctest::Approx(std::sqrt(4.0 / static_cast<double>(d.samples))));
}

TEST_CASE("the mean and mean square of a linear distance are integrated") {
    // a square over one that leans: the distance grows in proportion to x
    const TriangleMesh flat = shapes::square(1, 1);
    TriangleMesh leaning = shapes::square(3, 1);
    const double slope = 0.1;
    for (Vec3& p : leaning.positions) {
        p -= Vec3(1, 1, 0);
        p[2] = slope * p[0];
    }
    const SurfaceTree tree(leaning);
    const OneSidedDistance d = surface_distance(flat, tree, 100'000);
    const double cosine = 1 / std::sqrt(1 + slope * slope);
    CHECK(d.mean == doctest::Approx(slope * cosine / 2).epsilon(1e-4));
    CHECK(d.rms == doctest::Approx(slope * cosine / std::sqrt(3.0)).epsilon(1e-4));
    CHECK(d.max == doctest::Approx(slope * cosine).epsilon(1e-12)); // at a vertex, between samples
    CHECK(d.normal_deviation == doctest::Approx(std::acos(cosine) * 180 / std::numbers::pi));
}

TEST_CASE("concentric spheres are the difference of their radii apart") {
    const TriangleMesh inner = shapes::sphere(1.0, 60), outer = shapes::sphere(1.1, 80);
    const SurfaceTree tree(outer);
    CHECK(surface_distance(inner, tree, 20'000).rms == doctest::Approx(0.1).epsilon(0.01));
}

TEST_CASE("distances at vertices, at any number of threads") {
    const TriangleMesh mesh = shapes::blob(3000, 1), other = shapes::blob(2000, 2);
    const SurfaceTree tree(mesh);
    const std::vector<double> distances = vertex_distances(other, tree);
    const double rms = surface_distance(other, tree, 5000).rms;
    const ThreadLimit one(1);
    CHECK(vertex_distances(other, tree) == distances);
    CHECK(surface_distance(other, tree, 5000).rms == rms);
}
