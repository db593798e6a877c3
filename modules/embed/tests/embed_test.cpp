// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/embed.hpp>

#include <cmath>

#include <doctest/doctest.h>

#include <wm3d/core/error.hpp>
#include <wm3d/mesh.hpp>
#include <wm3d/shapes.hpp>

using namespace wm3d;
using namespace wm3d::embed;

namespace {

/// A blob as its own base domain, with one more vertex in the middle of triangle 0 standing off by `detail`.
struct Fixture {
    TriangleMesh base = shapes::blob(500, 4);
    TriangleMesh mesh = base;
    std::vector<SurfacePoint> place;
    Vec3 detail{0.01, -0.02, 0.03};

    Fixture() {
        place.resize(base.positions.size());
        for (std::size_t f = 0; f < base.triangles.size(); ++f)
            for (int k = 0; k < 3; ++k)
                place[base.triangles[f][k]] = {static_cast<Index>(f), Vec3::Unit(k)};
        place.push_back({0, Vec3(0.2, 0.3, 0.5)});
        mesh.positions.push_back(evaluate(base, place.back()) + detail);
        place.push_back({}); // isolated
        mesh.positions.push_back({7, 7, 7});
    }
};

std::vector<double> some_bumps(std::size_t n) {
    std::vector<double> delta(n);
    for (std::size_t i = 0; i < n; ++i)
        delta[i] = 0.1 * std::sin(3.7 * static_cast<double>(i));
    return delta;
}

} // namespace

TEST_CASE("base vertices move radially by gamma Delta") {
    const Fixture f;
    const std::vector<double> delta = some_bumps(f.base.positions.size());
    const std::vector<Vec3> marked = mark_base(f.base.positions, delta, 0.05);
    for (std::size_t i = 0; i < marked.size(); ++i) {
        const double r = f.base.positions[i].norm();
        CHECK(marked[i].norm() == doctest::Approx(r + 0.05 * delta[i]).epsilon(1e-13));
        CHECK(marked[i].cross(f.base.positions[i]).norm() < 1e-14);
    }
    const std::vector<Vec3> centre{Vec3::Zero()};
    CHECK(mark_base(centre, std::vector<double>{0.1}, 1.0).front() == Vec3::Zero());
}

TEST_CASE("details ride along, isolated vertices stay") {
    const Fixture f;
    const DetailedMesh detailed(f.mesh, f.base, f.place);
    const std::vector<Vec3> moved_base =
        mark_base(f.base.positions, some_bumps(f.base.positions.size()), 0.05);
    const std::vector<Vec3> moved = detailed.reconstruct(moved_base);
    for (std::size_t i = 0; i < f.base.positions.size(); ++i)
        CHECK((moved[i] - moved_base[i]).norm() < 1e-15);
    const Triangle& t = f.base.triangles[0];
    const Vec3 expected = 0.2 * moved_base[t[0]] + 0.3 * moved_base[t[1]] + 0.5 * moved_base[t[2]] + f.detail;
    CHECK((moved[f.base.positions.size()] - expected).norm() < 1e-14);
    CHECK(moved.back() == Vec3(7, 7, 7));
}

TEST_CASE("an unmoved base gives the very same positions") {
    const Fixture f;
    CHECK(DetailedMesh(f.mesh, f.base, f.place).reconstruct(f.base.positions) == f.mesh.positions);
}

TEST_CASE("distortion is linear in gamma and measures what moved") {
    const Fixture f;
    const DetailedMesh detailed(f.mesh, f.base, f.place);
    const std::vector<double> delta = some_bumps(f.base.positions.size());
    const auto at = [&](double gamma) {
        return distortion(f.mesh, detailed.reconstruct(mark_base(f.base.positions, delta, gamma)));
    };
    const Distortion one = at(0.01), two = at(0.02);
    CHECK(two.normal_rms == doctest::Approx(2 * one.normal_rms).epsilon(1e-9));
    CHECK(two.vertex_rms == doctest::Approx(2 * one.vertex_rms).epsilon(1e-9));
    CHECK(one.max <= 0.01 * 0.1 * (1 + 1e-9));
    CHECK(one.normal_rms < one.vertex_rms);
    // A sphere that grows moves along its normals alone.
    const TriangleMesh sphere = shapes::sphere(1, 40);
    std::vector<Vec3> grown = sphere.positions;
    for (Vec3& p : grown)
        p *= 1.01;
    CHECK(distortion(sphere, grown).normal_rms == doctest::Approx(0.01).epsilon(1e-3));
}

TEST_CASE("sizes that disagree are refused") {
    const Fixture f;
    CHECK_THROWS_AS(mark_base(f.base.positions, std::vector<double>(3), 1), ParameterError);
    CHECK_THROWS_AS(DetailedMesh(f.mesh, f.base, std::span(f.place).first(3)), ParameterError);
}
