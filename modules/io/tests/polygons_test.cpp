// SPDX-License-Identifier: GPL-3.0-or-later
#include "../src/polygons.hpp"

#include <doctest/doctest.h>

#include <wm3d/mesh/measure.hpp>

using namespace wm3d;
using namespace wm3d::io;

namespace {

TriangleMesh cut(const std::vector<Vec3>& positions) {
    Polygons polygons;
    for (std::size_t i = 0; i < positions.size(); ++i)
        polygons.corners.push_back(static_cast<Index>(i));
    polygons.close_face();
    return {positions, triangulate(positions, polygons)};
}

} // namespace

TEST_CASE("a convex polygon becomes a fan") {
    const TriangleMesh mesh = cut({{0, 0, 0}, {2, 0, 0}, {2, 2, 0}, {0, 2, 0}});
    CHECK(mesh.triangles == std::vector<Triangle>{{0, 1, 2}, {0, 2, 3}});
}

TEST_CASE("ears are clipped off a concave polygon: no triangle is turned over") {
    // An arrow head whose fan from the first corner would cover the notch.
    const TriangleMesh mesh = cut({{0, 0, 1}, {4, 0, 1}, {4, 4, 1}, {3, 1, 1}, {0, 4, 1}});
    CHECK(mesh.triangles.size() == 3);
    double sum = 0;
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
        CHECK(area_vector(mesh, f)[2] > 0);
        sum += area_vector(mesh, f)[2] / 2;
    }
    CHECK(sum == doctest::Approx(10.0)); // shoelace by hand
}

TEST_CASE("polygons without area and with repeated corners don't stop it") {
    CHECK(cut({{0, 0, 0}, {1, 0, 0}, {2, 0, 0}, {3, 0, 0}, {1, 0, 0}}).triangles.size() == 3);
    CHECK(cut({{0, 0, 0}, {1, 1, 0}, {1, 0, 0}, {0, 1, 0}}).triangles.size() == 2); // a bow tie
    CHECK(cut({{0, 0, 0}, {1, 0, 0}}).triangles.empty());
}

TEST_CASE("strips alternate so that all triangles look the same way") {
    std::vector<Triangle> triangles;
    const std::vector<Index> strip{0, 1, 2, 3, 4};
    append_strip(strip, triangles);
    CHECK(triangles == std::vector<Triangle>{{0, 1, 2}, {2, 1, 3}, {2, 3, 4}});
}
