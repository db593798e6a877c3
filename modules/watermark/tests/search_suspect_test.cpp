// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/watermark/search_suspect.hpp>

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>
#include <wm3d/core/error.hpp>
#include <wm3d/shapes/shapes.hpp>
#include <wm3d/shapes/turned.hpp>
#include <wm3d/watermark/mark.hpp>
#include <wm3d/watermark/verify.hpp>

#include "fixed_key.hpp"

using namespace wm3d;
using namespace wm3d::watermark;

namespace {

TriangleMesh marked(TriangleMesh mesh) {
    MarkOptions options;
    options.strength = 0.12;
    mesh.positions = mark(mesh, fixed_key(), options).positions;
    return mesh;
}

/// The part of a mesh on one side of a plane.
TriangleMesh cut(TriangleMesh mesh, const Vec3& normal, double height) {
    std::erase_if(mesh.triangles, [&](const Triangle& t) {
        return std::ranges::any_of(t, [&](Index v) { return mesh.positions[v].dot(normal) > height; });
    });
    return mesh;
}

void turn(TriangleMesh& mesh) {
    const Mat3 rotation = Eigen::AngleAxisd(1.1, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
    for (Vec3& p : mesh.positions)
        p = 3 * (rotation * p) + Vec3(5, 0, 2);
}

VerifyReport look(const TriangleMesh& mesh, double effort = 0.3) {
    VerifyOptions options;
    options.effort = effort;
    return verify(mesh, fixed_key(), options);
}

} // namespace

TEST_CASE("a cut and moved copy is found from the key alone, and the pose is told") {
    const TriangleMesh whole = marked(shapes::blob(6000, 3));
    const Frame truth = canonical_frame(whole);
    TriangleMesh part = cut(whole, Vec3::UnitZ(), 0.5 * truth.scale);
    turn(part);
    const VerifyReport report = look(part);
    REQUIRE(report.verdict == detect::Verdict::present);
    REQUIRE(report.search);
    CHECK(report.search->pose);
    CHECK(report.pose_origin == "search");
    CHECK(report.search->log10_hypotheses > 20);
    const Mat3 rotation = Eigen::AngleAxisd(1.1, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
    const Vec3 centre = 3 * (rotation * truth.centroid) + Vec3(5, 0, 2);
    CHECK((report.search->pose->frame.centroid - centre).norm() < 0.03 * truth.scale);

    // p is that of the best hypothesis times everything that was open.
    CHECK(report.score.log10_p ==
          doctest::Approx(report.score.best.log10_p + report.search->log10_hypotheses).epsilon(1e-9));
}

TEST_CASE("a mirror image is found and said to be one") {
    TriangleMesh mesh = marked(shapes::blob(4000, 5));
    for (Vec3& p : mesh.positions)
        p.y() = -p.y();
    for (Triangle& t : mesh.triangles)
        std::swap(t[0], t[1]);
    turn(mesh);
    const VerifyReport report = look(mesh, 0);
    CHECK(report.verdict == detect::Verdict::present);
    REQUIRE(report.search);
    REQUIRE(report.search->pose);
    CHECK(report.search->pose->mirrored);
    CHECK(report.search->centres == 0);
}

TEST_CASE("a model in a scene is found by the axes of its piece") {
    TriangleMesh scene = marked(shapes::blob(4000, 7));
    const TriangleMesh other = shapes::torus(5, 1, 40, 20);
    const auto first = static_cast<Index>(scene.positions.size());
    for (const Vec3& p : other.positions)
        scene.positions.push_back(p + Vec3(20, 0, 0));
    for (Triangle t : other.triangles)
        scene.triangles.push_back({t[0] + first, t[1] + first, t[2] + first});
    turn(scene);
    const VerifyReport report = look(scene, 0);
    CHECK(report.verdict == detect::Verdict::present);
    REQUIRE(report.search);
    REQUIRE(report.search->pose);
    CHECK(report.search->pose->piece);
}

TEST_CASE("a shape whose axes are unclear is found") {
    TriangleMesh gear = marked(shapes::gear(24, 8000));
    turn(gear);
    CHECK(look(gear, 1).verdict == detect::Verdict::present);
}

TEST_CASE(
    "a shape whose axes a small stretch turns is found, and absent from it is said without a long search") {
    TriangleMesh shape = shapes::blob(6000, 3);
    for (Vec3& p : shape.positions)
        p = p.cwiseProduct(Vec3(1, 1.3, 1.36));
    REQUIRE(Examination(shape, {}).ambiguity() == resync::Ambiguity::none);
    REQUIRE(Examination(shape, {}).moment_gap() < 0.2);
    TriangleMesh stretched = marked(shape);
    const Mat3 stretch = Vec3(1, 1.02, 0.98).asDiagonal();
    const Mat3 aslant = Eigen::AngleAxisd(0.7, Vec3(1, 0.3, -0.4).normalized()).toRotationMatrix();
    for (Vec3& p : stretched.positions)
        p = aslant.transpose() * stretch * aslant * p;
    turn(stretched);
    VerifyOptions by_axes;
    by_axes.search = SearchUse::never;
    CHECK(verify(stretched, fixed_key(), by_axes).verdict != detect::Verdict::present);
    const VerifyReport report = look(stretched, 1);
    CHECK(report.verdict == detect::Verdict::present);
    CHECK(report.pose_origin == "search");

    const VerifyReport unmarked = look(shape, 1);
    REQUIRE(unmarked.search);
    CHECK(unmarked.search->centres <= 48);
}

TEST_CASE("an unmarked part of something is not called present, nor absent without a search") {
    TriangleMesh part = cut(shapes::blob(3000, 9), Vec3::UnitX(), 0.3);
    const VerifyReport report = look(part, 0.01);
    CHECK(report.verdict == detect::Verdict::inconclusive);
    CHECK(report.search->centres > 0);
    CHECK_FALSE(report.search->complete);
    CHECK_FALSE(report.search->pose);
}

TEST_CASE("a cut through a thin limb is taken for one however small it is, and a hole for a hole") {
    TriangleMesh whole = shapes::blob(6000, 9);
    for (Vec3& p : whole.positions) // a limb along x
        p *= 1 + 1.5 * std::exp(-std::pow(std::acos(p.normalized().x()) / 0.05, 2));
    CHECK_FALSE(look(whole, 0).may_be_part);

    const VerifyReport report = look(cut(whole, Vec3::UnitX(), 1.8), 0.005);
    CHECK(report.largest_opening > 0.001);
    CHECK(report.largest_opening < 0.006);
    CHECK(report.may_be_part);
    CHECK(report.verdict == detect::Verdict::inconclusive);
    REQUIRE(report.search);
    CHECK(report.search->centres > 0);

    TriangleMesh hole = whole;
    std::erase_if(hole.triangles, [&](const Triangle& t) {
        return std::ranges::any_of(t, [&](Index v) { return hole.positions[v].normalized().z() < -0.99; });
    });
    const VerifyReport with_hole = look(hole, 0);
    CHECK(with_hole.largest_opening > 0.001);
    CHECK_FALSE(with_hole.may_be_part);
}

TEST_CASE("a cut that was closed by a plane face is taken for one") {
    TriangleMesh closed = shapes::blob(4000, 9);
    for (Vec3& p : closed.positions) // what lay beyond, pressed flat
        p.x() = std::min(p.x(), 0.6);
    const VerifyReport report = look(closed, 0.005);
    CHECK(report.largest_opening == 0);
    CHECK(report.lone_flat > 0.01);
    CHECK(report.verdict == detect::Verdict::inconclusive);
    REQUIRE(report.search);
    CHECK(report.search->centres > 0);
    CHECK(look(shapes::blob(4000, 9), 0).lone_flat == 0);
}

TEST_CASE("of a model in loose triangles nothing is called absent, however many they are") {
    const TriangleMesh whole = shapes::blob(17000, 3);
    TriangleMesh loose;
    for (const Triangle& t : whole.triangles) {
        const Vec3 centre = (whole.positions[t[0]] + whole.positions[t[1]] + whole.positions[t[2]]) / 3;
        const auto first = static_cast<Index>(loose.positions.size());
        for (const Index v : t) // no two corners in one place
            loose.positions.push_back(centre + 0.99 * (whole.positions[v] - centre));
        loose.triangles.push_back({first, first + 1, first + 2});
    }
    REQUIRE(loose.positions.size() > 100'000);
    const VerifyReport report = look(loose);
    CHECK(report.verdict == detect::Verdict::inconclusive);
    CHECK(report.doubt == Doubt::power);
    CHECK(report.base_vertices < 61'000);
    REQUIRE(report.search);
    CHECK(report.search->centres == 0); // loose triangles have no residual to search
}

TEST_CASE("vertices that are too few to show a mark are not searched, and said to be too few") {
    // Without the sides at z = 0, so that something may have been cut off.
    const auto open_box = [](std::size_t n) {
        TriangleMesh box = shapes::box({1, 2, 3}, n);
        std::erase_if(box.triangles, [&](const Triangle& t) {
            return std::ranges::all_of(t, [&](Index v) { return box.positions[v].z() == 0; });
        });
        return box;
    };
    const VerifyReport report = look(open_box(2), 1);
    CHECK(report.may_be_part);
    CHECK(report.verdict == detect::Verdict::inconclusive);
    CHECK(report.doubt == Doubt::vertices);
    REQUIRE(report.search);
    CHECK(report.search->centres == 0);
    REQUIRE(report.search->too_few);
    CHECK(report.search->too_few->vertices == 25);
    CHECK(report.search->too_few->most_sigmas < report.search->too_few->needed_sigmas);

    const VerifyReport enough = look(open_box(4), 0.005);
    CHECK(enough.doubt != Doubt::vertices);
    REQUIRE(enough.search);
    CHECK(enough.search->centres > 0);
    CHECK_FALSE(enough.search->too_few);
}

TEST_CASE("suspects with nothing to search end in an honest verdict") {
    const TriangleMesh triangle{{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
    const TriangleMesh needle{{{0, 0, 0}, {1, 0, 0}, {1, 1e-6, 0}, {0, 0, 1e-6}},
                              {{0, 1, 2}, {0, 2, 3}, {0, 3, 1}, {1, 3, 2}}};
    for (const TriangleMesh& mesh : {triangle, needle, shapes::square(1, 12)})
        CHECK(look(mesh, 0.02).verdict == detect::Verdict::inconclusive);
    CHECK_THROWS_AS(look(triangle, -1), ParameterError);
    CHECK_THROWS_AS(look(triangle, std::nan("")), ParameterError);
}
