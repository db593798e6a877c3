// SPDX-License-Identifier: GPL-3.0-or-later
#include "../src/flatten.hpp"

#include <cmath>
#include <numbers>

#include <doctest/doctest.h>

using namespace wm3d;
using namespace wm3d::maps;

namespace {

constexpr double pi = std::numbers::pi;

double angle(const Vec2& a, const Vec2& b) {
    return std::atan2(a[0] * b[1] - a[1] * b[0], a.dot(b));
}

} // namespace

TEST_CASE("a flat closed ring only turns and shrinks") {
    std::vector<Vec3> ring;
    for (double at : {0.3, 1.4, 2.0, 3.9, 5.0})
        ring.push_back(4 * Vec3{std::cos(at), std::sin(at), 0} * (1 + 0.1 * at));
    std::vector<Vec2> plane;
    flatten(ring, true, plane);
    REQUIRE(plane.size() == 5);
    const double longest = ring[4].norm();
    for (std::size_t i = 0; i < 5; ++i) {
        CHECK(plane[i].norm() == doctest::Approx(ring[i].norm() / longest).epsilon(1e-14));
        const std::size_t j = (i + 1) % 5;
        CHECK(angle(plane[i], plane[j]) ==
              doctest::Approx(std::acos(ring[i].normalized().dot(ring[j].normalized()))));
    }
    CHECK(plane[0][1] == 0);
}

TEST_CASE("a cone opens by z -> z^a") {
    // three spokes along the axes: 90 degrees between them, a = 4/3
    const std::vector<Vec3> ring{{1, 0, 0}, {0, 0.5, 0}, {0, 0, 0.25}};
    std::vector<Vec2> plane;
    flatten(ring, true, plane);
    for (std::size_t i = 0; i < 3; ++i) {
        CHECK(angle(plane[i], plane[(i + 1) % 3]) == doctest::Approx(2 * pi / 3).epsilon(1e-14));
        CHECK(plane[i].norm() == doctest::Approx(std::pow(ring[i].norm(), 4.0 / 3)).epsilon(1e-14));
    }
}

TEST_CASE("an open ring opens to a half-plane, its ends exactly on the axis") {
    const std::vector<Vec3> ring{{2, 0, 0}, {0, 1, 0}, {0, 0, 1}, {0, -1, 0}};
    std::vector<Vec2> plane;
    flatten(ring, false, plane); // a = pi / (3 pi / 2)
    CHECK(plane.front() == Vec2{1, 0});
    CHECK(plane.back()[1] == 0);
    CHECK(plane.back()[0] == doctest::Approx(-std::pow(0.5, 2.0 / 3)).epsilon(1e-14));
    CHECK(angle(plane[0], plane[1]) == doctest::Approx(pi / 3).epsilon(1e-14));
}

TEST_CASE("rings without angles or lengths give finite points") {
    std::vector<Vec2> plane;
    for (const std::vector<Vec3>& ring :
         {std::vector<Vec3>(4, Vec3::Zero()), std::vector<Vec3>(3, Vec3{1, 0, 0}),
          std::vector<Vec3>{{1, 0, 0}, {1, 1e-8, 0}, {1, 0, 0}, {1e-300, 0, 0}}})
        for (bool closed : {true, false}) {
            flatten(ring, closed, plane);
            for (const Vec2& p : plane)
                CHECK(p.allFinite());
        }
}
