// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/mesh/frame.hpp>

#include <cmath>
#include <cstdint>
#include <numbers>
#include <utility>

#include <Eigen/Geometry>
#include <doctest/doctest.h>

#include <wm3d/core/error.hpp>
#include <wm3d/core/parallel.hpp>
#include <wm3d/mesh/measure.hpp>
#include <wm3d/mesh/weld.hpp>

using namespace wm3d;

namespace {

/// A wedge-like tetrahedron with no symmetry.
TriangleMesh uneven_tetrahedron() {
    return {{{0, 0, 0}, {4, 0, 0}, {0, 2, 0}, {0.5, 0.25, 1}}, {{0, 2, 1}, {0, 1, 3}, {1, 2, 3}, {2, 0, 3}}};
}

/// Every triangle split at its edge midpoints: the same surface with four times the triangles.
TriangleMesh split(const TriangleMesh& mesh) {
    TriangleMesh fine;
    for (const Triangle& t : mesh.triangles) {
        const auto base = static_cast<Index>(fine.positions.size());
        for (Index v : t)
            fine.positions.push_back(mesh.positions[v]);
        for (int k = 0; k < 3; ++k)
            fine.positions.push_back(0.5 * (mesh.positions[t[k]] + mesh.positions[t[(k + 1) % 3]]));
        for (const Triangle& s : {Triangle{0, 3, 5}, {3, 1, 4}, {5, 4, 2}, {3, 4, 5}})
            fine.triangles.push_back({base + s[0], base + s[1], base + s[2]});
    }
    return fine;
}

} // namespace

TEST_CASE("moments of a rectangle are those of the formula") {
    const TriangleMesh rectangle{{{1, 1, 5}, {7, 1, 5}, {7, 3, 5}, {1, 3, 5}}, {{0, 1, 2}, {0, 2, 3}}};
    const SurfaceMoments m = surface_moments(rectangle);
    CHECK(m.area == doctest::Approx(12));
    CHECK((m.centroid - Vec3(4, 2, 5)).norm() < 1e-14);
    CHECK(m.covariance(0, 0) == doctest::Approx(36.0 / 12));
    CHECK(m.covariance(1, 1) == doctest::Approx(4.0 / 12));
    CHECK(std::abs(m.covariance(0, 1)) < 1e-14);
    CHECK(m.covariance(2, 2) == doctest::Approx(0));
}

TEST_CASE("moments and frame don't depend on the triangulation") {
    const TriangleMesh coarse = uneven_tetrahedron(), fine = split(split(coarse));
    const SurfaceMoments a = surface_moments(coarse), b = surface_moments(fine);
    CHECK((a.centroid - b.centroid).norm() < 1e-14);
    CHECK((a.covariance - b.covariance).norm() < 1e-14);
    CHECK((canonical_frame(coarse).axes - canonical_frame(fine).axes).norm() < 1e-12);
    CHECK(canonical_frame(coarse).scale == doctest::Approx(canonical_frame(fine).scale).epsilon(0.01));
}

TEST_CASE("moments of a solid are exact on a box, whichever way its triangles look") {
    // [0, 2] x [0, 4] x [0, 6], each side two triangles
    TriangleMesh box{{{0, 0, 0}, {2, 0, 0}, {2, 4, 0}, {0, 4, 0}, {0, 0, 6}, {2, 0, 6}, {2, 4, 6}, {0, 4, 6}},
                     {{0, 2, 1},
                      {0, 3, 2},
                      {4, 5, 6},
                      {4, 6, 7},
                      {0, 1, 5},
                      {0, 5, 4},
                      {1, 2, 6},
                      {1, 6, 5},
                      {2, 3, 7},
                      {2, 7, 6},
                      {3, 0, 4},
                      {3, 4, 7}}};
    const double area = 2 * (8 + 12 + 24);
    for (double sign : {1.0, -1.0}) {
        const SolidMoments m = solid_moments(box);
        CHECK(m.volume == doctest::Approx(sign * 48));
        CHECK((m.centroid - Vec3(1, 2, 3)).norm() < 1e-14);
        const Vec3 variance(4.0 / 12, 16.0 / 12, 36.0 / 12);
        CHECK((m.covariance - Mat3(variance.asDiagonal())).norm() < 1e-14);
        CHECK(m.sphericity == doctest::Approx(36 * std::numbers::pi * 48 * 48 / (area * area * area)));
        CHECK(m.openness < 1e-15);
        CHECK(shape_moments(box).substance() == Substance::solid);
        CHECK(shape_moments(box).possible_substances().size() == 1);
        for (Triangle& t : box.triangles)
            std::swap(t[1], t[2]);
    }
}

TEST_CASE("a sheet is a surface, a box without a small window a solid, one without a side a surface") {
    const TriangleMesh sheet{{{1, 1, 5}, {7, 1, 5}, {7, 3, 5}, {1, 3, 5}}, {{0, 1, 2}, {0, 2, 3}}};
    CHECK(shape_moments(sheet).substance() == Substance::surface);
    CHECK(solid_moments(sheet).openness == doctest::Approx(1));
    const TriangleMesh fine = split(split(split(uneven_tetrahedron())));
    TriangleMesh window = fine, side = fine;
    window.triangles.erase(window.triangles.begin() + 5);
    side.triangles.erase(side.triangles.begin(),
                         side.triangles.begin() + static_cast<std::ptrdiff_t>(side.triangles.size() / 4));
    CHECK(shape_moments(window).substance() == Substance::solid);
    CHECK(shape_moments(side).substance() == Substance::surface);
    // A cone from the centroid fills the window, so little moves.
    const SolidMoments a = solid_moments(fine), b = solid_moments(window);
    CHECK((a.centroid - b.centroid).norm() < 0.01 * mean_radius(fine, a.centroid));
}

TEST_CASE("noise that moves a surface in and out leaves the solid's frame alone and shifts the surface's") {
    // Half of the tetrahedron's vertices, those of positive x, jitter along fixed directions.
    TriangleMesh mesh = uneven_tetrahedron();
    for (int i = 0; i < 7; ++i)
        mesh = split(mesh);
    mesh = weld(mesh.positions, mesh.triangles).mesh; // else the noise tears it open
    TriangleMesh rough = mesh;
    std::uint64_t state = 1;
    const auto uniform = [&] {
        state = state * 6364136223846793005u + 1442695040888963407u;
        return static_cast<double>(state >> 11) * 0x1p-52 - 1;
    };
    const Frame surface = canonical_frame(mesh, Substance::surface);
    for (Vec3& p : rough.positions)
        if (p.x() > surface.centroid.x())
            p += 0.01 * surface.scale * Vec3(uniform(), uniform(), uniform());
    const auto shift = [&](Substance s) {
        return (canonical_frame(rough, s).centroid - canonical_frame(mesh, s).centroid).norm() /
               surface.scale;
    };
    CHECK(shift(Substance::surface) > 5 * shift(Substance::solid));
}

TEST_CASE("the canonical frame follows a similarity transform") {
    const TriangleMesh mesh = uneven_tetrahedron();
    const Mat3 rotation = Eigen::AngleAxisd(2.1, Vec3(1, -2, 0.5).normalized()).toRotationMatrix();
    TriangleMesh moved = mesh;
    for (Vec3& p : moved.positions)
        p = 3.5 * (rotation * p) + Vec3(10, -20, 5);
    const TriangleMesh a = to_frame(mesh, canonical_frame(mesh)), b = to_frame(moved, canonical_frame(moved));
    for (std::size_t v = 0; v < a.positions.size(); ++v)
        CHECK((a.positions[v] - b.positions[v]).norm() < 1e-12);
}

TEST_CASE("in the canonical frame the centroid is 0 and the mean radius 1, and the way back is exact") {
    const TriangleMesh mesh = uneven_tetrahedron();
    const Frame frame = canonical_frame(mesh);
    CHECK(frame.axes.determinant() == doctest::Approx(1));
    const TriangleMesh moved = to_frame(mesh, frame);
    CHECK(solid_moments(moved).centroid.norm() < 1e-13);
    CHECK(mean_radius(moved, Vec3::Zero()) == doctest::Approx(1).epsilon(1e-14));
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        CHECK((frame.from_canonical(moved.positions[v]) - mesh.positions[v]).norm() < 1e-14);
}

TEST_CASE("the mean radius of a fine sphere-like surface is close to its radius") {
    // An octahedron split and pushed to the unit sphere.
    TriangleMesh ball{
        {{1, 0, 0}, {-1, 0, 0}, {0, 1, 0}, {0, -1, 0}, {0, 0, 1}, {0, 0, -1}},
        {{0, 2, 4}, {2, 1, 4}, {1, 3, 4}, {3, 0, 4}, {2, 0, 5}, {1, 2, 5}, {3, 1, 5}, {0, 3, 5}}};
    for (int i = 0; i < 5; ++i) {
        ball = split(ball);
        for (Vec3& p : ball.positions)
            p.normalize();
    }
    CHECK(mean_radius(ball, Vec3::Zero()) == doctest::Approx(1).epsilon(1e-3));
}

TEST_CASE("the four sign choices are proper rotations, all different, the first unchanged") {
    const std::array<Frame, 4> choices = sign_choices(canonical_frame(uneven_tetrahedron()));
    for (const Frame& f : choices)
        CHECK(f.axes.determinant() == doctest::Approx(1));
    CHECK(choices[0].axes == canonical_frame(uneven_tetrahedron()).axes);
    for (int i = 0; i < 4; ++i)
        for (int j = 0; j < i; ++j)
            CHECK((choices[i].axes - choices[j].axes).norm() > 1);
}

TEST_CASE("a surface without area has no frame, and the message says so") {
    CHECK_THROWS_AS(canonical_frame(TriangleMesh{}), GeometryError);
    const TriangleMesh line{{{0, 0, 0}, {1, 1, 1}, {2, 2, 2}}, {{0, 1, 2}}};
    CHECK_THROWS_WITH_AS(canonical_frame(line), doctest::Contains("no surface area"), GeometryError);
}

TEST_CASE("a mesh whose powers leave the range of double is refused for its size") {
    const auto scaled = [](double factor) {
        TriangleMesh mesh = split(split(uneven_tetrahedron()));
        for (Vec3& p : mesh.positions)
            p *= factor;
        return mesh;
    };
    for (const double factor : {1e-300, 1e-150, 1e-55, 1e55, 1e150, 1e300})
        CHECK_THROWS_WITH_AS(canonical_frame(scaled(factor)), doctest::Contains("scale the model"),
                             GeometryError);
    const double sphericity = shape_moments(scaled(1)).solid.sphericity;
    for (const double factor : {1e-45, 1e-30, 1e30, 1e45})
        CHECK(shape_moments(scaled(factor)).solid.sphericity == doctest::Approx(sphericity));
}

TEST_CASE("the frame has the same bits at one thread and at many") {
    TriangleMesh mesh = uneven_tetrahedron();
    for (int i = 0; i < 8; ++i)
        mesh = split(mesh);
    const Frame many = canonical_frame(mesh);
    const ThreadLimit one(1);
    const Frame single = canonical_frame(mesh);
    CHECK(many.axes == single.axes);
    CHECK(many.centroid == single.centroid);
    CHECK(many.scale == single.scale);
}
