// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/maps/base_domain.hpp>

#include <cmath>
#include <map>
#include <utility>

#include <doctest/doctest.h>
#include <wm3d/core/parallel.hpp>
#include <wm3d/shapes.hpp>

#include "support.hpp"

using namespace wm3d;
using namespace wm3d::maps;
using namespace wm3d::maps::test;

TEST_CASE("every vertex has a place, base vertices their own corner") {
    for (const TriangleMesh& mesh :
         {shapes::blob(3000, 3), shapes::torus(3, 1, 40, 20), shapes::square(1, 20),
          shapes::box({1, 2, 3}, 8), shapes::ellipsoid({3, 1, 0.2}, 20)})
        for (std::size_t target : {2000u, 300u, 40u, 5u}) {
            CAPTURE(target);
            const BaseDomain domain = parameterize(mesh, {.target_vertices = target});
            check_domain(mesh, domain);
            CHECK(domain.relocations >= domain.collapses);
            CHECK(domain.clamped * 100 <= domain.relocations);
        }
}

TEST_CASE("the base domain is what the simplification gives") {
    const TriangleMesh mesh = shapes::blob(2000, 7);
    const simplify::Options options{.target_vertices = 150};
    const simplify::Result coarse = simplify::simplify(mesh, options);
    const BaseDomain domain = parameterize(mesh, options);
    CHECK(domain.mesh.positions == coarse.mesh.positions);
    CHECK(domain.mesh.triangles == coarse.mesh.triangles);
    CHECK(domain.original == coarse.original);
    CHECK(domain.error == coarse.error);
    CHECK(domain.collapses == coarse.collapses);
    CHECK(domain.stop == coarse.stop);
}

TEST_CASE("a flat mesh is parameterized by itself") {
    const TriangleMesh mesh = shapes::square(1, 30);
    for (std::size_t target : {500u, 60u, 4u}) {
        const BaseDomain domain = parameterize(mesh, {.target_vertices = target});
        REQUIRE(domain.stop == simplify::Stop::reached);
        double worst = 0;
        for (Index v = 0; v < mesh.positions.size(); ++v)
            worst = std::max(worst, (image(domain, v) - mesh.positions[v]).norm());
        CHECK(worst < 1e-12);
        CHECK(domain.folded == 0);
    }
}

TEST_CASE("vertices of the boundary go to the boundary") {
    TriangleMesh mesh = shapes::square(1, 24);
    for (Vec3& p : mesh.positions)
        p[2] = 0.3 * std::sin(5 * p[0]) * std::cos(4 * p[1]);
    const BaseDomain domain = parameterize(mesh, {.target_vertices = 40});
    std::map<std::pair<Index, Index>, int> edges;
    const auto edge = [](Index a, Index b) { return std::pair(std::min(a, b), std::max(a, b)); };
    for (const Triangle& t : domain.mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k)
            ++edges[edge(t[k], t[(k + 1) % 3])];
    for (Index v = 0; v < mesh.positions.size(); ++v) {
        const Index i = v / 25, j = v % 25;
        if (i != 0 && i != 24 && j != 0 && j != 24)
            continue;
        const SurfacePoint& p = domain.point[v];
        const Triangle& t = domain.mesh.triangles[p.triangle];
        bool on_boundary = p.barycentric.maxCoeff() == 1; // a base vertex
        for (Eigen::Index k = 0; k < 3; ++k)
            on_boundary = on_boundary || (p.barycentric[k] == 0 &&
                                          edges[edge(t[static_cast<std::size_t>((k + 1) % 3)],
                                                     t[static_cast<std::size_t>((k + 2) % 3)])] == 1);
        CHECK(on_boundary);
    }
}

TEST_CASE("the map hardly leaves the surface and keeps its sides") {
    const TriangleMesh mesh = shapes::sphere(1, 60);
    const BaseDomain domain = parameterize(mesh, {.target_vertices = 800});
    double worst = 0;
    for (Index v = 0; v < mesh.positions.size(); ++v)
        worst = std::max(worst, (image(domain, v) - mesh.positions[v]).norm());
    CHECK(worst < 0.08); // base triangles have sides of about 0.13
    std::size_t same = 0, turned = 0;
    for (const Triangle& t : mesh.triangles) {
        const SurfacePoint &a = domain.point[t[0]], &b = domain.point[t[1]], &c = domain.point[t[2]];
        if (a.triangle != b.triangle || b.triangle != c.triangle)
            continue;
        ++same;
        Mat3 images;
        images << a.barycentric, b.barycentric, c.barycentric;
        turned += images.determinant() < -1e-12;
    }
    CHECK(same > 1000);
    CHECK(turned * 200 <= same);
}

TEST_CASE("isolated vertices have no place; copies at complex vertices have one") {
    TriangleMesh mesh = shapes::sphere(1, 10);
    const auto south = static_cast<Index>(mesh.positions.size() - 1);
    const TriangleMesh second = shapes::sphere(1, 10);
    const auto shift = static_cast<Index>(mesh.positions.size());
    for (const Vec3& p : second.positions)
        mesh.positions.push_back(p - Vec3{0, 0, 2});
    for (const Triangle& t : second.triangles) {
        Triangle moved{t[0] + shift, t[1] + shift, t[2] + shift};
        std::ranges::replace(moved, shift, south); // both meet in one vertex
        mesh.triangles.push_back(moved);
    }
    mesh.triangles.push_back({3, 3, 4});
    const BaseDomain domain = parameterize(mesh, {.target_vertices = 40});
    check_domain(mesh, domain);
    CHECK(domain.point[shift].triangle == no_index);
    CHECK(domain.point[south].barycentric.maxCoeff() == 1);
}

TEST_CASE("one thread and many give the same bytes") {
    const TriangleMesh mesh = shapes::blob(30000, 8);
    const BaseDomain many = parameterize(mesh, {.target_vertices = 1500});
    const ThreadLimit one(1);
    const BaseDomain single = parameterize(mesh, {.target_vertices = 1500});
    bool same = many.original == single.original && many.mesh.triangles == single.mesh.triangles;
    for (std::size_t v = 0; v < many.point.size(); ++v)
        same = same && many.point[v].triangle == single.point[v].triangle &&
               many.point[v].barycentric == single.point[v].barycentric;
    CHECK(same);
}

TEST_CASE("nothing to map") {
    CHECK(parameterize({}, {}).point.empty());
    const TriangleMesh sphere = shapes::sphere(1, 6);
    const BaseDomain same = parameterize(sphere, {.target_vertices = 1000});
    CHECK(same.stop == simplify::Stop::already_small);
    CHECK(same.relocations == 0);
    check_domain(sphere, same);
}
