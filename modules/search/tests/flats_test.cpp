// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/search/flats.hpp>

#include <cmath>
#include <numbers>

#include <doctest/doctest.h>
#include <wm3d/mesh/measure.hpp>

#include "random_points.hpp"

using namespace wm3d;
using namespace wm3d::search;

namespace {

/// A sphere by longitudes and latitudes, cut off at z = top and closed there by a fan, turned and shifted.
TriangleMesh capped_sphere(double top) {
    constexpr Index rings = 60, columns = 80;
    TriangleMesh mesh;
    const double first = std::acos(top);
    for (Index r = 0; r <= rings; ++r)
        for (Index c = 0; c < columns; ++c) {
            const double theta = first + (std::numbers::pi - 0.01 - first) * r / rings,
                         phi = 2 * std::numbers::pi * c / columns;
            mesh.positions.emplace_back(std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi),
                                        std::cos(theta));
        }
    for (Index r = 0; r < rings; ++r)
        for (Index c = 0; c < columns; ++c) {
            const Index a = r * columns + c, b = r * columns + (c + 1) % columns;
            mesh.triangles.push_back({a, a + columns, b});
            mesh.triangles.push_back({b, a + columns, b + columns});
        }
    if (top < 1)
        for (Index c = 2; c < columns; ++c)
            mesh.triangles.push_back({0, c - 1, c});
    const Mat3 turn = random_rotation(5);
    for (Vec3& p : mesh.positions)
        p = 10 * (turn * p) + Vec3(100, -50, 7);
    return mesh;
}

TriangleMesh box() {
    TriangleMesh mesh;
    for (Index k = 0; k < 8; ++k)
        mesh.positions.emplace_back((k & 1) != 0 ? 3 : 0, (k & 2) != 0 ? 2 : 0, (k & 4) != 0 ? 1 : 0);
    mesh.triangles = {{0, 2, 1}, {1, 2, 3}, {4, 5, 6}, {5, 7, 6}, {0, 1, 4}, {1, 5, 4},
                      {2, 6, 3}, {3, 6, 7}, {0, 4, 2}, {2, 4, 6}, {1, 3, 5}, {3, 7, 5}};
    return mesh;
}

} // namespace

TEST_CASE("a cut that was closed is a lone flat, where it is and as it faces") {
    const TriangleMesh mesh = capped_sphere(0.8);
    const Flat flat = lone_flat(mesh);
    const double cap = std::numbers::pi * (1 - 0.64), rest = 2 * std::numbers::pi * 1.8;
    CHECK(flat.area == doctest::Approx(cap / (cap + rest)).epsilon(0.01));
    const Vec3 axis = random_rotation(5) * Vec3::UnitZ();
    CHECK((flat.normal - axis).norm() < 1e-6);
    CHECK((flat.centre - (8 * axis + Vec3(100, -50, 7))).norm() < 0.01);
}

TEST_CASE("a curved surface has no flat, and a box has six, none of them alone") {
    CHECK(flats(capped_sphere(1)).empty());
    const std::vector<Flat> all = flats(box());
    REQUIRE(all.size() == 6);
    CHECK(all[0].area == doctest::Approx(6.0 / 22));
    CHECK(all[5].area == doctest::Approx(2.0 / 22));
    CHECK(lone_flat(box()).area == 0);
    CHECK(flats({}).empty());
}
