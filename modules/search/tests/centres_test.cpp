// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/search/centres.hpp>

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>
#include <wm3d/sphere/icosphere.hpp>

#include "random_points.hpp"

using namespace wm3d;
using namespace wm3d::search;

namespace {

/// The sphere's faces below a height, around a centre.
TriangleMesh cap_below(double height, const Vec3& centre) {
    TriangleMesh mesh = sphere::Icosphere(3).mesh();
    std::erase_if(mesh.triangles, [&](const Triangle& t) {
        return std::ranges::any_of(t, [&](Index v) { return mesh.positions[v].z() > height; });
    });
    for (Vec3& p : mesh.positions)
        p += centre;
    return mesh;
}

} // namespace

TEST_CASE("an opening tells the side on which something is missing") {
    TriangleMesh mesh = cap_below(0.5, Vec3(3, 0, 0));
    const Outline out = outline(mesh);
    CHECK(out.outwards.z() > 0.999);
    CHECK(out.opening > 0.1);
    CHECK(out.centroid.x() == doctest::Approx(3));
    for (Triangle& t : mesh.triangles) // seen from inside
        std::swap(t[0], t[1]);
    CHECK(outline(mesh).outwards.z() > 0.999);
    CHECK(outline(sphere::Icosphere(2).mesh()).outwards.isZero());
}

TEST_CASE("an oblique cut of a long thing lies towards its end, wherever the cut looks") {
    TriangleMesh mesh = sphere::Icosphere(4).mesh();
    for (Vec3& p : mesh.positions)
        p.z() *= 4;
    std::erase_if(mesh.triangles, [&](const Triangle& t) { // the plane looks along x rather than z
        return std::ranges::any_of(
            t, [&](Index v) { return mesh.positions[v].x() + 0.25 * mesh.positions[v].z() > 0.6; });
    });
    const Outline out = outline(mesh);
    CHECK(out.outwards.z() > 0.8);
    CHECK(out.outwards.x() > 0.1);
}

TEST_CASE("every place near the centroid has a centre within the covering radius") {
    Outline closed;
    closed.centroid = Vec3(1, 2, 3);
    closed.radius = 10;
    CentreOptions options;
    options.covering = 0.05;
    const std::vector<Vec3> found = centres(closed, 3000, options);
    CHECK(found.size() == 3000);
    CHECK(found.front() == closed.centroid);
    Numbers number(1);
    for (int k = 0; k < 300; ++k) {
        const Vec3 place = closed.centroid + closed.radius * 0.2 * Vec3(number(), number(), number());
        double nearest = 1e300;
        for (const Vec3& c : found)
            nearest = std::min(nearest, (c - place).norm());
        CHECK(nearest < closed.radius * options.covering * 1.02);
    }
}

TEST_CASE("centres beyond the opening come first") {
    Outline open;
    open.outwards = Vec3::UnitX();
    open.opening = 0.1;
    const std::vector<Vec3> found = centres(open, 500);
    Vec3 mean = Vec3::Zero();
    for (const Vec3& c : found)
        mean += c / 500;
    CHECK(mean.x() > 0.15);
    CHECK(std::hypot(mean.y(), mean.z()) < 0.02);
    CHECK(centres(open, 0).empty());
    CHECK(centres(open, 200) == std::vector<Vec3>(found.begin(), found.begin() + 200));
}
