// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/resync/registration.hpp>

#include <doctest/doctest.h>

#include <wm3d/attack/cropping.hpp>
#include <wm3d/attack/perturbation.hpp>
#include <wm3d/shapes/sample.hpp>
#include <wm3d/shapes/shapes.hpp>

#include "moved.hpp"

using namespace wm3d;
using resync::Registration;
using resync::Similarity;
using resync::test::moved;

namespace {

const Similarity far_away{Eigen::AngleAxisd(2.4, Vec3(1, 2, -0.5).normalized()).toRotationMatrix(), 7.5,
                          Vec3(20, -3, 11)};

TriangleMesh lumpy() {
    return shapes::blob(6000, 5);
}

void check_found(const Registration& found, const Similarity& truth, double degrees, double relative) {
    CHECK(found.aligned);
    CHECK(resync::angle_between(found.transform.rotation, truth.rotation) < degrees);
    CHECK(found.transform.scale == doctest::Approx(truth.scale).epsilon(relative));
    CHECK((found.transform.translation - truth.translation).norm() < relative * truth.scale);
}

} // namespace

TEST_CASE("a moved copy is aligned from its principal axes, exactly") {
    const TriangleMesh mesh = lumpy();
    const Registration found =
        resync::register_template(resync::make_template(mesh, 1500), moved(mesh, far_away));
    check_found(found, far_away, 0.01, 1e-4);
    CHECK_FALSE(found.searched);
    CHECK(found.coverage > 0.95);
    CHECK(found.residual < 1e-3);
}

TEST_CASE("a cut copy is aligned by matching pairs of points") {
    const TriangleMesh mesh = lumpy();
    const resync::PoseTemplate remembered = resync::make_template(mesh, 1500);
    for (std::uint64_t seed : {1, 2, 3}) {
        attack::CropOptions cut;
        cut.percent = 45;
        const TriangleMesh part = attack::crop(mesh, cut, seed);
        check_found(resync::register_template(remembered, moved(part, far_away)), far_away, 0.1, 3e-3);
    }
}

TEST_CASE("inside-out triangles don't matter, on either side") {
    TriangleMesh mesh = lumpy(), turned = mesh;
    for (Triangle& t : turned.triangles)
        std::swap(t[0], t[1]);
    check_found(resync::register_template(resync::make_template(turned, 1500), moved(mesh, far_away)),
                far_away, 0.01, 1e-4);
    check_found(resync::register_template(resync::make_template(turned, 1500), moved(turned, far_away)),
                far_away, 0.01, 1e-4);
}

TEST_CASE("noise does not keep a copy from being aligned") {
    const TriangleMesh mesh = lumpy();
    const TriangleMesh noisy = attack::add_noise(mesh, 0.5, 1);
    check_found(resync::register_template(resync::make_template(mesh, 1500), moved(noisy, far_away)),
                far_away, 0.1, 2e-3);
}

TEST_CASE("a mirror image is aligned and told, whichever way its triangles turn") {
    const TriangleMesh mesh = lumpy();
    TriangleMesh mirrored = mesh;
    for (Vec3& p : mirrored.positions)
        p.x() = -p.x();
    const resync::PoseTemplate remembered = resync::make_template(mesh, 1500);
    const Registration inside_out = resync::register_template(remembered, moved(mirrored, far_away));
    CHECK(inside_out.aligned);
    CHECK(inside_out.transform.mirrors());
    for (Triangle& t : mirrored.triangles)
        std::swap(t[0], t[1]);
    const Registration found = resync::register_template(remembered, moved(mirrored, far_away));
    CHECK(found.aligned);
    CHECK(found.transform.mirrors());
    const Vec3 p(0.3, 0.4, 0.5);
    CHECK((found.transform(p) - far_away(Vec3(-0.3, 0.4, 0.5))).norm() < 0.02 * far_away.scale);
}

TEST_CASE("another object is not aligned") {
    const resync::PoseTemplate remembered = resync::make_template(lumpy(), 1500);
    CHECK_FALSE(resync::register_template(remembered, shapes::torus(1, 0.3, 60, 30)).aligned);
    CHECK_FALSE(resync::register_template(remembered, shapes::box({1, 2, 3}, 20)).aligned);
}

TEST_CASE("a sphere can be aligned in any pose, and nothing is sure about it") {
    const Registration found = resync::register_template(resync::make_template(shapes::sphere(1, 40), 1500),
                                                         moved(shapes::sphere(1, 40), far_away));
    CHECK(found.aligned);
    CHECK(found.confidence < 0.05);
}
