// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/detect/surface_filter.hpp>

#include <cmath>

#include <doctest/doctest.h>

#include <wm3d/core/parallel.hpp>
#include <wm3d/shapes.hpp>

#include "support.hpp"

using namespace wm3d;
using detect::SurfaceFilter;
using detect::test::dot;

namespace {

std::vector<double> field(std::size_t n, double step) {
    std::vector<double> x(n);
    for (std::size_t i = 0; i < n; ++i)
        x[i] = std::sin(step * static_cast<double>(i) + 0.3);
    return x;
}

} // namespace

TEST_CASE("constants pass, integrals are kept, values never leave their range") {
    const TriangleMesh mesh = shapes::blob(2000, 3);
    const SurfaceFilter filter(mesh);
    const std::vector<double> x = field(mesh.positions.size(), 1.7);
    const auto smooth = filter.low_pass(0.01, {x, std::vector<double>(x.size(), 2.5)});
    for (double y : smooth[1])
        CHECK(y == doctest::Approx(2.5).epsilon(1e-6));
    CHECK(std::abs(dot(filter.mass(), smooth[0]) - dot(filter.mass(), x)) <
          1e-5 * dot(filter.mass(), std::vector<double>(x.size(), 1.0)));
    for (double y : smooth[0])
        CHECK(std::abs(y) <= 1);
}

TEST_CASE("the transpose is the transpose") {
    const TriangleMesh mesh = shapes::torus(1, 0.4, 40, 20);
    const SurfaceFilter filter(mesh);
    const std::vector<double> x = field(mesh.positions.size(), 0.7), y = field(mesh.positions.size(), 2.9);
    const double left = dot(y, filter.low_pass(0.003, {x}).front());
    const double right = dot(filter.low_pass_transposed(0.003, y), x);
    CHECK(left == doctest::Approx(right).epsilon(1e-4)); // the solver stops at a relative residual of 3e-6
}

TEST_CASE("on a sphere a linear function is an eigenvector: it shrinks by 1 / (1 + 2t)") {
    const TriangleMesh mesh = shapes::sphere(1, 60);
    const SurfaceFilter filter(mesh);
    std::vector<double> z(mesh.positions.size());
    for (std::size_t i = 0; i < z.size(); ++i)
        z[i] = mesh.positions[i].z();
    const double t = 0.05;
    const std::vector<double> smooth = filter.low_pass(t, {z}).front();
    for (std::size_t i = 0; i < z.size(); ++i)
        CHECK(smooth[i] == doctest::Approx(z[i] / (1 + 2 * t)).epsilon(2e-3).scale(1));
}

TEST_CASE("degenerate triangles and isolated vertices are borne") {
    TriangleMesh mesh = shapes::square(1, 6);
    mesh.positions.push_back({9, 9, 9});
    mesh.triangles.push_back({0, 1, 2}); // three points on a line
    const SurfaceFilter filter(mesh);
    const auto smooth = filter.low_pass(0.01, {field(mesh.positions.size(), 1.1)}).front();
    for (double y : smooth)
        CHECK(std::isfinite(y));
}

TEST_CASE("the same bytes at one thread and at many") {
    const TriangleMesh mesh = shapes::blob(3000, 5);
    const SurfaceFilter filter(mesh);
    const std::vector<std::vector<double>> x{field(mesh.positions.size(), 1.0),
                                             field(mesh.positions.size(), 2.0)};
    const auto many = filter.low_pass(0.001, x);
    const ThreadLimit one(1);
    CHECK(filter.low_pass(0.001, x) == many);
}
