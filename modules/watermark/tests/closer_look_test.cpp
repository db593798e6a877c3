// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/watermark/closer_look.hpp>

#include <cmath>

#include <doctest/doctest.h>
#include <wm3d/key/stream.hpp>
#include <wm3d/shapes/shapes.hpp>
#include <wm3d/watermark/mark.hpp>
#include <wm3d/watermark/verify.hpp>

#include "fixed_key.hpp"

using namespace wm3d;
using namespace wm3d::watermark;

namespace {

constexpr std::size_t few = 1500;

VerifyOptions quick_look(bool closer) {
    VerifyOptions options;
    options.vertices = few;
    options.search = SearchUse::never;
    options.look_closer = closer;
    return options;
}

/// A marked blob of mean radius about 1 that noise has gone over.
TriangleMesh noisy_mark(double noise) {
    TriangleMesh mesh = shapes::blob(8000, 5);
    mesh.positions = mark(mesh, fixed_key(), {}).positions;
    std::vector<double> numbers(3 * mesh.positions.size());
    key::Stream(key::null_secret(41, 0), key::Purpose::trial, 0).fill_symmetric(numbers, noise);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        mesh.positions[i] += Vec3(numbers[3 * i], numbers[3 * i + 1], numbers[3 * i + 2]);
    return mesh;
}

} // namespace

TEST_CASE("a closer look finds what simplification took, in the pose of the first, and both are paid for") {
    const TriangleMesh suspect = noisy_mark(0.004);
    const VerifyReport first = verify(suspect, fixed_key(), quick_look(false));
    const VerifyReport both = verify(suspect, fixed_key(), quick_look(true));
    CHECK(first.verdict != detect::Verdict::present);
    CHECK(first.base_vertices <= few);
    CHECK(both.verdict == detect::Verdict::present);
    CHECK(both.base_vertices == suspect.positions.size());
    CHECK(both.expected_sigmas > first.expected_sigmas);
}

TEST_CASE("a suspect that wasn't simplified, or has too many vertices, is looked at once") {
    const TriangleMesh small = shapes::blob(1000, 5);
    CHECK_FALSE(can_look_closer(simplify_suspect(small, few)));
    CHECK(can_look_closer(simplify_suspect(small, few / 3)));
    const TriangleMesh large = shapes::sphere(1, 200);
    REQUIRE(large.positions.size() > most_examined);
    CHECK_FALSE(can_look_closer({large, small}));
}

TEST_CASE("the price of two looks is that of twice the hypotheses") {
    detect::FamilyScore score;
    score.hypotheses = 240;
    score.log10_p = -10;
    CHECK(one_of_two_looks(score).hypotheses == 480);
    CHECK(one_of_two_looks(score).log10_p == doctest::Approx(-10 + std::log10(2.0)));
    score.log10_p = -0.1;
    CHECK(one_of_two_looks(score).log10_p == 0);
}
