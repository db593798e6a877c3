// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/maps/equations.hpp>

#include <doctest/doctest.h>

using namespace wm3d;
using namespace wm3d::maps;

namespace {

const Corners triangle{Vec3{1, 2, 3}, Vec3{4, 2, 3}, Vec3{1, 6, 5}};

} // namespace

TEST_CASE("equation (1): corners, middle and a point by hand") {
    for (int k = 0; k < 3; ++k)
        CHECK(base_point(triangle, Vec3::Unit(k)) == triangle[static_cast<std::size_t>(k)]);
    CHECK((base_point(triangle, {0.5, 0.25, 0.25}) - Vec3{1.75, 3, 3.5}).norm() < 1e-15);
}

TEST_CASE("barycentric coordinates undo equation (1), inside and out") {
    for (const Vec3& c : {Vec3{0.2, 0.3, 0.5}, Vec3{1, 0, 0}, Vec3{-1, 0.5, 1.5}, Vec3{0, 0, 1}})
        CHECK((barycentric_coordinates(base_point(triangle, c), triangle) - c).norm() < 1e-14);
    const Vec3 above = base_point(triangle, {0.2, 0.3, 0.5}) +
                       7 * (triangle[1] - triangle[0]).cross(triangle[2] - triangle[0]);
    CHECK((barycentric_coordinates(above, triangle) - Vec3{0.2, 0.3, 0.5}).norm() < 1e-12);
}

TEST_CASE("triangles without area have coordinates too") {
    const Corners segment{Vec3{0, 0, 0}, Vec3{1, 0, 0}, Vec3{4, 0, 0}};
    const Vec3 on = barycentric_coordinates({1, 5, 0}, segment);
    CHECK(on.minCoeff() >= 0);
    CHECK((base_point(segment, on) - Vec3{1, 0, 0}).norm() < 1e-15);
    CHECK(barycentric_coordinates({9, 0, 0}, segment) == Vec3{0, 0, 1});
    const Vec3 p{2, 2, 2};
    CHECK(barycentric_coordinates({5, 5, 5}, {p, p, p}) == Vec3{1, 0, 0});
}

TEST_CASE("equation (2): the same weights on the original's corners") {
    const Corners originals{Vec3{0, 0, 10}, Vec3{1, 0, 20}, Vec3{0, 1, 40}};
    const Vec3 c{0.5, 0.2, 0.3};
    const Vec3 expected{0.2, 0.3, 21};
    CHECK((original_point(base_point(triangle, c), triangle, originals) - expected).norm() < 1e-14);
    CHECK((original_point(c, originals) - expected).norm() < 1e-14);
}
