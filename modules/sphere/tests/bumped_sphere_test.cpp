// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/sphere/bumped_sphere.hpp>

#include <cmath>

#include <doctest/doctest.h>
#include <wm3d/core/error.hpp>
#include <wm3d/core/parallel.hpp>

#include "directions.hpp"

using namespace wm3d;
using namespace wm3d::sphere;

namespace {

/// Distance at which the ray from the origin meets the mesh, looking at all triangles.
double ray_distance(const TriangleMesh& mesh, const Vec3& direction) {
    double margin = -1, distance = 0;
    for (const Triangle& t : mesh.triangles) {
        Mat3 corners;
        corners << mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]];
        const Vec3 weights = corners.inverse() * direction.normalized();
        if (weights.minCoeff() > margin && weights.sum() > 0) {
            margin = weights.minCoeff();
            distance = 1 / weights.sum();
        }
    }
    return distance;
}

BumpedSphere bumped(unsigned level, double rmax, double radius = 1) {
    Icosphere sphere(level);
    std::vector<double> w = random_heights(sphere.vertices().size(), rmax, level + 1);
    return BumpedSphere(std::move(sphere), std::move(w), radius);
}

} // namespace

TEST_CASE("R_P is where the ray meets the bumped mesh") {
    for (unsigned level = 0; level <= 3; ++level)
        for (const auto& [rmax, radius] : {std::pair{0.1, 1.0}, std::pair{0.9, 1.0}, std::pair{0.5, 2.0}}) {
            const BumpedSphere sphere = bumped(level, rmax, radius);
            const TriangleMesh mesh = sphere.mesh();
            for (const Vec3& direction : random_directions(100, level))
                CHECK(std::abs(sphere.radius_at(direction) - ray_distance(mesh, direction)) < 1e-13);
        }
}

TEST_CASE("R_P at a vertex is R + w") {
    const BumpedSphere sphere = bumped(5, 0.1);
    double worst = 0;
    for (std::size_t j = 0; j < sphere.heights().size(); ++j)
        worst = std::max(worst,
                         std::abs(sphere.radius_at(sphere.sphere().vertices()[j]) - 1 - sphere.heights()[j]));
    CHECK(worst < 1e-13);
}

TEST_CASE("linearization costs no more than its bound, and the bound is not idle") {
    for (unsigned level = 1; level <= 6; ++level)
        for (double rmax : {0.01, 0.1, 0.5}) {
            const BumpedSphere sphere = bumped(level, rmax);
            double most_used = 0;
            for (const Vec3& direction : random_directions(3000, level)) {
                const SphereLocation at = sphere.sphere().locate(direction);
                const double cost = linear_delta(at, sphere.heights()) - delta(at, sphere.heights());
                const double bound = linearization_bound(at.flat_radius, rmax);
                CHECK(cost >= -1e-15);
                CHECK(cost <= bound + 1e-15);
                most_used = std::max(most_used, cost / bound);
            }
            CHECK(most_used > 0.5);
        }
}

TEST_CASE("the bound is reached where one corner is high and the others low") {
    const Icosphere sphere(0);
    const Triangle& t = sphere.faces()[7];
    const double rmax = 0.4;
    std::vector<double> w(sphere.vertices().size(), -rmax);
    w[t[0]] = rmax;
    const double b =
        std::sqrt(1 + rmax) / (std::sqrt(1 + rmax) + std::sqrt(1 - rmax)); // weight of the high corner
    SphereLocation at{7, t, Vec3(b, 1 - b, 0), 1.0};                       // as if the face were round
    CHECK(linear_delta(at, w) - delta(at, w) ==
          doctest::Approx(linearization_bound(1.0, rmax)).epsilon(1e-13));
}

TEST_CASE("without bumps Delta is what the flat faces lack, and vanishes as h^2") {
    double last = 0;
    for (unsigned level = 2; level <= 6; ++level) {
        Icosphere sphere(level);
        std::vector<double> none(sphere.vertices().size(), 0.0);
        const BumpedSphere flat(std::move(sphere), std::move(none));
        double deepest = 0;
        for (double x : flat.deltas(random_directions(4000, 1))) {
            CHECK(x <= 1e-15);
            deepest = std::min(deepest, x);
        }
        if (level > 2)
            CHECK(last / deepest == doctest::Approx(4).epsilon(0.1));
        last = deepest;
    }
}

TEST_CASE("deltas are those of the single directions, at one thread and at many") {
    const BumpedSphere sphere = bumped(4, 0.1);
    const std::vector<Vec3> directions = random_directions(5000, 2);
    const std::vector<double> many = sphere.deltas(directions);
    const ThreadLimit one(1);
    CHECK(sphere.deltas(directions) == many);
    CHECK(many[1234] == sphere.radius_at(directions[1234]) - 1);
}

TEST_CASE("heights that don't fit are refused") {
    CHECK_THROWS_AS(BumpedSphere(Icosphere(1), std::vector<double>(41, 0.0)), ParameterError);
    CHECK_THROWS_AS(BumpedSphere(Icosphere(1), std::vector<double>(42, -1.0)), ParameterError);
    CHECK_THROWS_AS(BumpedSphere(Icosphere(1), std::vector<double>(42, std::nan(""))), ParameterError);
}
