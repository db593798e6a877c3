// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/search/pose_search.hpp>

#include <cmath>

#include <doctest/doctest.h>
#include <wm3d/mesh/measure.hpp>

#include "random_points.hpp"

using namespace wm3d;
using namespace wm3d::search;

namespace {

/// A lumpy ball that bears the bumps of a key around a centre and turned.
struct Marked {
    sphere::Icosphere sphere{3};
    KeyFunction key{sphere, WeightedPoints(sphere.vertices().size(), 21).weights, 1};
    TriangleMesh mesh = sphere::Icosphere(5).mesh();

    Marked(const Pose& truth, double strength) {
        for (Vec3& p : mesh.positions) {
            p *= 1 + 0.1 * p.x() * p.y() + 0.08 * std::sin(3 * p.z());
            const Vec3 d = (p - truth.centre).normalized();
            p += strength * key(truth.direction(p)).value * d;
        }
    }

    SearchOutcome search(std::span<const Vec3> centres, bool mirrored, const Accept& accept) const {
        SearchOptions options;
        options.bandwidth = 24;
        const Target target{3, &key, mirrored, centres};
        return search_poses(mesh.positions, detect::Evidence(mesh), std::span(&target, 1), accept, options);
    }
};

} // namespace

TEST_CASE("a known pose is found, mirrored or not") {
    for (const bool mirrored : {false, true}) {
        Pose truth;
        truth.centre = Vec3(0.15, -0.05, 0.1);
        truth.turn = (mirrored ? -1 : 1) * random_rotation(8);
        const Marked marked(truth, 0.004);
        const std::vector<Vec3> centres{Vec3(-0.4, 0, 0), Vec3::Zero(), Vec3(0.12, -0.03, 0.13)};
        Pose found;
        const SearchOutcome outcome = marked.search(centres, mirrored, [&](const Candidate& candidate) {
            found = candidate.pose;
            return true;
        });
        CHECK(outcome.accepted);
        CHECK(outcome.centres == 3);
        CHECK(outcome.rotations == 3 * std::pow(48, 3));
        CHECK((found.centre - truth.centre).norm() < 0.005);
        CHECK((found.turn - truth.turn).norm() < 0.01);
        CHECK(found.mirrors() == mirrored);
        CHECK_FALSE(marked.search(centres, !mirrored, [](const Candidate&) { return true; }).accepted);
    }
}

TEST_CASE("a search for nothing, or in nothing, ends") {
    const Marked plain(Pose{}, 0);
    const auto never = [](const Candidate&) { return false; };
    CHECK(plain.search({}, false, never).centres == 0);
    const TriangleMesh flat{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
    const std::vector<Vec3> one{Vec3(0.3, 0.3, 0)}; // in the plane: no radial move shows
    const Target target{3, &plain.key, false, one};
    const SearchOutcome outcome =
        search_poses(flat.positions, detect::Evidence(flat), std::span(&target, 1), never);
    CHECK(outcome.centres == 1);
    CHECK_FALSE(outcome.accepted);
}
