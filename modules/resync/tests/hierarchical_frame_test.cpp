// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/resync/hierarchical_frame.hpp>

#include <doctest/doctest.h>

#include <wm3d/resync/similarity.hpp>
#include <wm3d/shapes/sample.hpp>
#include <wm3d/shapes/shapes.hpp>

#include "moved.hpp"

using namespace wm3d;
using resync::test::moved;

namespace {

resync::FrameEstimate estimate(const TriangleMesh& mesh) {
    return resync::estimate_frame(mesh, mesh, {.levels = {1500, 500}});
}

/// Smallest angle between a frame and the candidates.
double nearest(const std::vector<resync::CandidatePose>& poses, const Frame& truth) {
    double angle = 180;
    for (const resync::CandidatePose& pose : poses)
        angle = std::min(angle, resync::angle_between(pose.frame.axes, truth.axes));
    return angle;
}

} // namespace

TEST_CASE("the frame moves with the mesh, and the first candidate is the canonical frame") {
    const TriangleMesh blob = shapes::blob(6000, 3);
    const resync::Similarity t{Eigen::AngleAxisd(2.1, Vec3(1, -2, 0.5).normalized()).toRotationMatrix(), 3.7,
                               Vec3(10, -4, 2)};
    const resync::FrameEstimate found = estimate(moved(blob, t));
    const Frame truth = resync::moved(canonical_frame(blob), t);
    CHECK((found.finest.centroid - truth.centroid).norm() < 1e-9);
    CHECK(found.finest.scale == doctest::Approx(truth.scale).epsilon(1e-12));
    const auto poses = resync::candidate_poses(found);
    CHECK(poses.front().frame.axes == found.finest.axes);
    CHECK(poses.size() % 4 == 0);
    CHECK(nearest(poses, truth) < 1e-6);
}

TEST_CASE("the levels agree on a shape with clear axes, and only few poses are tried") {
    const resync::FrameEstimate found = estimate(shapes::ellipsoid({1, 0.7, 0.45}, 60));
    CHECK(found.ambiguity == resync::Ambiguity::none);
    CHECK(found.levels.size() == 3);
    CHECK(found.uncertainty.maxCoeff() < 1);
    CHECK(resync::angle_between(found.robust.axes, found.finest.axes) < 1);
    CHECK(resync::candidate_poses(found).size() <= 8);
}

TEST_CASE("a sphere, a cube and a body of revolution are ambiguous") {
    CHECK(estimate(shapes::sphere(2, 30)).ambiguity == resync::Ambiguity::all);
    CHECK(resync::ambiguity_of(shape_moments(shapes::sphere(2, 30)).own()) == resync::Ambiguity::all);
    CHECK(estimate(shapes::box({1, 1, 1}, 12)).ambiguity == resync::Ambiguity::all);
    CHECK(estimate(shapes::ellipsoid({1, 1, 0.5}, 30)).ambiguity == resync::Ambiguity::plane);
    CHECK(estimate(shapes::torus(1, 0.3, 40, 20)).ambiguity == resync::Ambiguity::plane);
    CHECK(estimate(shapes::box({1, 2, 3}, 12)).ambiguity == resync::Ambiguity::none);
}

TEST_CASE("where two moments are equal, turns and an exchange of axes are tried, up to the limit") {
    const resync::FrameEstimate found = estimate(shapes::box({1, 1, 3}, 12));
    const auto poses = resync::candidate_poses(found, {.step = 1, .most = 9});
    CHECK(poses.size() == 36);
    Frame exchanged = found.finest;
    exchanged.axes = Eigen::AngleAxisd(EIGEN_PI / 2, Vec3::UnitX()).toRotationMatrix() * exchanged.axes;
    CHECK(nearest(poses, exchanged) < 1e-6);
    Frame turned = found.finest;
    turned.axes = Eigen::AngleAxisd(2 * EIGEN_PI / 180, Vec3::UnitX()).toRotationMatrix() * turned.axes;
    CHECK(nearest(poses, turned) < 1e-6);
}

TEST_CASE("a similarity and its inverse compose to nothing, and tell mirrors") {
    const resync::Similarity t{Eigen::AngleAxisd(1, Vec3(1, 1, 0).normalized()).toRotationMatrix(), 0.2,
                               Vec3(1, 2, 3)};
    const Vec3 p(0.3, -2, 5);
    CHECK(((t * t.inverse())(p)-p).norm() < 1e-12);
    CHECK(((t.matrix() * p.homogeneous()).head<3>() - t(p)).norm() < 1e-12);
    CHECK_FALSE(t.mirrors());
    CHECK(resync::Similarity{-t.rotation, 1, Vec3::Zero()}.mirrors());
}
