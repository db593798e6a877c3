// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/search/refine.hpp>

#include <cmath>

#include <doctest/doctest.h>

#include "random_points.hpp"

using namespace wm3d;
using namespace wm3d::search;

namespace {

/// Points of a lumpy shell, each saying what the key has in its direction from the true pose.
struct Scene {
    sphere::Icosphere sphere{3};
    KeyFunction key;
    std::vector<Vec3> x;
    std::vector<double> q;

    explicit Scene(const Pose& truth) : key(sphere, WeightedPoints(sphere.vertices().size(), 5).weights, 1) {
        const WeightedPoints points(4000, 6);
        for (const Vec3& p : points.directions) {
            x.push_back(truth.centre + p.normalized() * (1 + 0.2 * p.x()));
            q.push_back(key(truth.direction(x.back())).value);
        }
    }
};

Pose a_pose(Deformation deformation) {
    Pose pose;
    pose.centre = Vec3(0.2, -0.1, 0.3);
    pose.turn = random_rotation(4);
    pose.deformation = deformation;
    if (deformation != Deformation::none)
        pose.stretch << 0.02, 0.01, 0, 0.01, -0.03, 0.02, 0, 0.02, 0.01;
    if (deformation == Deformation::bent)
        pose.bend(0, 1) = 0.03;
    return pose;
}

} // namespace

TEST_CASE("the gradient of the key's function is its slope") {
    const sphere::Icosphere sphere(2);
    const KeyFunction key(sphere, WeightedPoints(sphere.vertices().size(), 2).weights, 1);
    const WeightedPoints points(50, 3);
    for (const Vec3& d : points.directions) {
        const KeyFunction::Value at = key(d);
        for (int k = 0; k < 3; ++k) {
            const Vec3 step = 1e-6 * Vec3::Unit(k);
            const double slope = (key(d + step).value - key(d - step).value) / 2e-6;
            CHECK(std::abs(slope - at.gradient[k]) < 1e-5 * (1 + std::abs(slope)));
        }
    }
    CHECK(key(Vec3::Zero()).gradient.isZero());
}

TEST_CASE("refinement comes back to the pose, deformed or not") {
    for (const Deformation deformation : {Deformation::none, Deformation::affine, Deformation::bent}) {
        const Pose truth = a_pose(deformation);
        const Scene scene(truth);
        Pose start = truth;
        start.centre += Vec3(0.01, 0.01, -0.015);
        start.turn = Eigen::AngleAxisd(0.02, Vec3(1, 1, 0).normalized()).toRotationMatrix() * truth.turn;
        if (deformation != Deformation::none)
            start.stretch.setZero();
        const double before = correlation(scene.x, scene.q, scene.key, start);
        RefineOptions options;
        options.iterations = 200;
        const Refined found = refine(scene.x, scene.q, scene.key, start, options);
        const double best = correlation(scene.x, scene.q, scene.key, truth);
        CHECK(before < 0.97 * best);
        CHECK(found.value > 0.995 * best);
        CHECK(found.value == doctest::Approx(correlation(scene.x, scene.q, scene.key, found.pose)));
        if (deformation == Deformation::none)
            CHECK((found.pose.centre - truth.centre).norm() < 0.002);
    }
}

TEST_CASE("nothing to climb is an arrival at the start") {
    const sphere::Icosphere sphere(1);
    const KeyFunction flat(sphere, std::vector<double>(sphere.vertices().size(), 0.5), 1);
    const std::vector<Vec3> x{Vec3::UnitX(), Vec3::Zero()};
    const Refined found = refine(x, std::vector<double>{1, 1}, flat, Pose{});
    CHECK(found.pose.turn.isIdentity());
    CHECK(found.value == doctest::Approx(1));
}
