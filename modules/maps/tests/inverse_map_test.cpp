// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/maps/inverse_map.hpp>

#include <doctest/doctest.h>
#include <wm3d/shapes.hpp>

#include "support.hpp"

using namespace wm3d;
using namespace wm3d::maps;
using namespace wm3d::maps::test;

namespace {

/// Points spread over the base triangles.
std::vector<SurfacePoint> samples(const BaseDomain& domain) {
    std::vector<SurfacePoint> points;
    for (Index t = 0; t < domain.mesh.triangles.size(); ++t)
        for (const Vec3& c : {Vec3{1, 1, 1}, Vec3{4, 1, 1}, Vec3{0, 1, 1}, Vec3{2, 5, 0}, Vec3{1, 1, 30}})
            points.push_back({t, c / c.sum()});
    return points;
}

/// Largest distance of a returned sample from where it lies on the base domain.
double farthest_from_domain(const TriangleMesh& mesh, const BaseDomain& domain) {
    const InverseMap inverse(mesh, domain);
    double worst = 0;
    for (const SurfacePoint& p : samples(domain))
        worst = std::max(worst, (inverse.to_surface(p) - evaluate(domain.mesh, p)).norm());
    return worst;
}

} // namespace

TEST_CASE("vertices come back from their places") {
    for (const TriangleMesh& mesh : {shapes::blob(3000, 3), shapes::torus(3, 1, 40, 20),
                                     shapes::square(1, 20), shapes::box({1, 2, 3}, 8)})
        for (std::size_t target : {3000u, 1000u, 300u, 40u}) {
            CAPTURE(target);
            CHECK(not_returned(mesh, parameterize(mesh, {.target_vertices = target}), 1e-9) == 0);
        }
}

TEST_CASE("on a flat mesh the inverse is the identity everywhere") {
    const TriangleMesh mesh = shapes::square(1, 25);
    for (std::size_t target : {500u, 50u, 4u}) {
        const BaseDomain domain = parameterize(mesh, {.target_vertices = target});
        CHECK(farthest_from_domain(mesh, domain) < 1e-9);
    }
}

TEST_CASE("without a collapse the base domain is the surface") {
    const TriangleMesh mesh = shapes::blob(600, 3);
    const BaseDomain domain = parameterize(mesh, {.target_vertices = 100000});
    CHECK(farthest_from_domain(mesh, domain) < 1e-12);
}

TEST_CASE("points of the base domain return to the surface near them") {
    const TriangleMesh mesh = shapes::sphere(1, 60);
    const BaseDomain domain = parameterize(mesh, {.target_vertices = 600});
    const InverseMap inverse(mesh, domain);
    double worst = 0, sum = 0;
    const std::vector<SurfacePoint> points = samples(domain);
    for (const SurfacePoint& p : points) {
        const SurfacePoint at = inverse.locate(p);
        REQUIRE(at.triangle < mesh.triangles.size());
        CHECK(at.barycentric.minCoeff() >= 0);
        CHECK(at.barycentric.sum() == doctest::Approx(1).epsilon(1e-12));
        CHECK(inverse.to_surface(p) == evaluate(mesh, at));
        const double distance = (inverse.to_surface(p) - evaluate(domain.mesh, p)).norm();
        worst = std::max(worst, distance);
        sum += distance;
    }
    CHECK(worst < 0.1); // base triangles have sides of about 0.15
    CHECK(sum / static_cast<double>(points.size()) < 0.02);
}

TEST_CASE("neighbouring points return to neighbouring points") {
    const TriangleMesh mesh = shapes::blob(8000, 5);
    const BaseDomain domain = parameterize(mesh, {.target_vertices = 300});
    const InverseMap inverse(mesh, domain);
    std::size_t jumps = 0, steps = 0;
    for (Index t = 0; t < domain.mesh.triangles.size(); ++t)
        for (double x = 0.05; x < 0.95; x += 0.05, ++steps) {
            const SurfacePoint a{t, {x, 0.5 * (1 - x), 0.5 * (1 - x)}};
            const SurfacePoint b{t, {x + 0.01, 0.5 * (0.99 - x), 0.5 * (0.99 - x)}};
            const double base_step = (evaluate(domain.mesh, a) - evaluate(domain.mesh, b)).norm();
            jumps += (inverse.to_surface(a) - inverse.to_surface(b)).norm() > 8 * base_step;
        }
    CHECK(jumps * 100 < steps);
}
