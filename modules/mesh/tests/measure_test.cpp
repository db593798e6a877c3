// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/mesh/measure.hpp>

#include <cmath>
#include <numeric>

#include <doctest/doctest.h>

using namespace wm3d;

namespace {

/// Corner of the unit cube at the origin: three right triangles, and one vertex that none of them uses.
TriangleMesh corner() {
    return {{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {0, 0, 1}, {9, 9, 9}}, {{0, 2, 1}, {0, 3, 2}, {0, 1, 3}}};
}

} // namespace

TEST_CASE("boxes of points and of the surface") {
    const TriangleMesh mesh = corner();
    CHECK(bounding_box(mesh.positions).max == Vec3(9, 9, 9));
    CHECK(surface_box(mesh).max == Vec3(1, 1, 1));
    CHECK(surface_box(mesh).diagonal() == doctest::Approx(std::sqrt(3.0)));
    CHECK(bounding_box({}).diagonal() == 0);
    CHECK(surface_box(TriangleMesh{}).diagonal() == 0);
}

TEST_CASE("areas add up, on triangles and on vertices") {
    const TriangleMesh mesh = corner();
    CHECK(surface_area(mesh) == doctest::Approx(1.5));
    const std::vector<double> at_vertices = vertex_areas(mesh);
    CHECK(std::accumulate(at_vertices.begin(), at_vertices.end(), 0.0) == doctest::Approx(1.5));
    CHECK(at_vertices[0] == doctest::Approx(0.5));
    CHECK(at_vertices[4] == 0);
}

TEST_CASE("vertex normals are unit, or zero where nothing defines them") {
    const TriangleMesh mesh = corner();
    const std::vector<Vec3> normals = vertex_normals(mesh);
    const Vec3 diagonal = Vec3::Constant(-1 / std::sqrt(3.0));
    CHECK((normals[0] - diagonal).norm() < 1e-15);
    CHECK(normals[4] == Vec3::Zero());
    const TriangleMesh flat{{{0, 0, 0}, {1, 0, 0}, {2, 0, 0}}, {{0, 1, 2}}};
    CHECK(vertex_normals(flat)[1] == Vec3::Zero());
}
