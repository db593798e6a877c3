// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/metrics/msdm2.hpp>

#include <algorithm>
#include <cmath>

#include <doctest/doctest.h>
#include <wm3d/core.hpp>
#include <wm3d/mesh.hpp>
#include <wm3d/shapes.hpp>

using namespace wm3d;
using namespace wm3d::metrics;

namespace {

/// Vertices moved along their normals, alternating, by a share of the box diagonal in %.
TriangleMesh roughened(const TriangleMesh& mesh, double percent) {
    TriangleMesh rough = mesh;
    const double height = percent / 100 * surface_box(mesh).diagonal();
    const std::vector<Vec3> normals = vertex_normals(mesh);
    for (std::size_t v = 0; v < rough.positions.size(); ++v)
        rough.positions[v] += (v % 3 == 0 ? height : -height / 2) * normals[v];
    return rough;
}

double distance(const TriangleMesh& reference, const TriangleMesh& distorted) {
    const SurfaceTree tree(reference);
    return Msdm2(tree).distance(distorted);
}

std::vector<double> field(const TriangleMesh& reference, const TriangleMesh& distorted) {
    const SurfaceTree tree(reference);
    return Msdm2(tree).field(distorted);
}

/// The same surface with other numbers of vertices and triangles.
TriangleMesh renumbered(const TriangleMesh& mesh) {
    const auto count = static_cast<Index>(mesh.positions.size());
    TriangleMesh result;
    result.positions.assign(mesh.positions.rbegin(), mesh.positions.rend());
    for (const Triangle& t : mesh.triangles)
        result.triangles.push_back({count - 1 - t[1], count - 1 - t[2], count - 1 - t[0]});
    return result;
}

} // namespace

TEST_CASE("the same surface is at 0, and roughness counts more the more of it there is") {
    const TriangleMesh mesh = shapes::blob(20000, 1);
    CHECK(distance(mesh, mesh) < 1e-9);
    double last = 0;
    for (double percent : {0.01, 0.05, 0.2}) {
        const double d = distance(mesh, roughened(mesh, percent));
        CHECK(d > last);
        CHECK(d < 1);
        last = d;
    }
    CHECK(last > 0.3);
}

TEST_CASE("a smooth change of the same size is seen less than a rough one") {
    const TriangleMesh mesh = shapes::blob(20000, 1);
    TriangleMesh stretched = mesh;
    for (Vec3& p : stretched.positions)
        p[0] *= 1.004; // moves of the order of 0.2 % of the diagonal
    CHECK(distance(mesh, stretched) < 0.3 * distance(mesh, roughened(mesh, 0.2)));
}

TEST_CASE("it is free of scale and of the numbering") {
    const TriangleMesh mesh = shapes::blob(5000, 1);
    const TriangleMesh rough = roughened(mesh, 0.1);
    const auto scaled = [](TriangleMesh m) {
        for (Vec3& p : m.positions)
            p *= 1024; // exactly: which edges lead outwards must not hang on rounding
        return m;
    };
    const double d = distance(mesh, rough);
    CHECK(distance(scaled(mesh), scaled(rough)) == doctest::Approx(d).epsilon(1e-6));
    CHECK(distance(mesh, renumbered(rough)) == doctest::Approx(d).epsilon(1e-9));
}

TEST_CASE("two spheres have the value that the formulas give") {
    // Constant curvatures: no deviation, no covariance, L alone. Windows are wide enough for the triangles.
    const double growth = 1.2;
    const TriangleMesh unit = shapes::sphere(1, 48), larger = shapes::sphere(growth, 48);
    Msdm2Options options;
    options.scales = {0.10, 0.12, 0.14};
    options.curvature_ratio = 0.8;
    const SurfaceTree small_tree(unit), large_tree(larger);
    const double outwards = (2 * growth - 2) / (2 * growth + 1); // S = 2 growth: C = 2, C^ = 2 growth
    const double inwards = (2 - 2 / growth) / (2 + 1);           // S = 2: C = 2, C^ = 2 / growth
    const double parts = 1 + 1 + 0.5;
    CHECK(Msdm2(small_tree, options).distance(larger) == doctest::Approx(outwards / parts).epsilon(0.02));
    CHECK(Msdm2(large_tree, options).distance(unit) == doctest::Approx(inwards / parts).epsilon(0.02));
}

TEST_CASE("one reference serves many meshes, of its triangles or of others") {
    const TriangleMesh mesh = shapes::blob(8000, 1);
    const SurfaceTree tree(mesh);
    const Msdm2 measure(tree);
    for (double percent : {0.02, 0.1, 4.0}) { // the last beyond the triangles around
        const TriangleMesh rough = roughened(mesh, percent);
        CHECK(measure.distance(rough) == distance(mesh, rough));
        CHECK(measure.distance(renumbered(rough)) == doctest::Approx(measure.distance(rough)).epsilon(1e-9));
    }
    CHECK(measure.distance(mesh) < 1e-9);
    CHECK(measure.distance(shapes::blob(3000, 1)) > 0);
    CHECK_THROWS_AS(measure.distance(TriangleMesh{}), GeometryError);
}

TEST_CASE("the distance is the mean of the field over the vertices of triangles") {
    const TriangleMesh mesh = shapes::blob(4000, 1);
    TriangleMesh rough = roughened(mesh, 0.1);
    const double before = distance(mesh, rough);
    rough.positions.emplace_back(100, 0, 0); // isolated: no part of the surface
    rough.positions.emplace_back(0, 0, 0);
    const std::vector<double> local = field(mesh, rough);
    CHECK(local.size() == rough.positions.size());
    CHECK(local.back() == 0);
    CHECK(msdm2_mean(rough, local) == doctest::Approx(before).epsilon(1e-12));
    CHECK(distance(mesh, rough) == doctest::Approx(before).epsilon(1e-12));
}

TEST_CASE("fewer windows estimate the same distance") {
    const TriangleMesh mesh = shapes::blob(20000, 1);
    const TriangleMesh rough = roughened(mesh, 0.05);
    const SurfaceTree tree(mesh);
    const Msdm2 measure(tree);
    const double full = measure.distance(rough);
    CHECK(measure.sample(rough, 1'000'000).mean == doctest::Approx(full).epsilon(1e-3));
    const std::vector<double> field = measure.field(rough);
    for (std::size_t windows : {4000, 300}) { // the latter far apart
        const Msdm2Sample sample = measure.sample(rough, windows);
        CHECK(sample.vertices.size() <= windows);
        CHECK(sample.local.size() == sample.vertices.size());
        CHECK(sample.mean == doctest::Approx(full).epsilon(windows < 1000 ? 0.1 : 0.02));
        for (std::size_t i = 0; i < sample.local.size(); i += 10)
            CHECK(sample.local[i] == doctest::Approx(field[sample.vertices[i]]).epsilon(0.02));
    }
}

TEST_CASE("the bytes are the same at any number of threads") {
    const TriangleMesh mesh = shapes::blob(9000, 1);
    const TriangleMesh rough = roughened(mesh, 0.1);
    const auto on = [&](std::size_t threads) {
        const ThreadLimit limit(threads);
        return std::pair(distance(mesh, rough), field(mesh, rough));
    };
    CHECK(on(1) == on(2));
    CHECK(on(1) == on(7));
}

TEST_CASE("turning and moving both meshes changes nothing but the box") {
    const TriangleMesh mesh = shapes::sphere(1, 40), rough = roughened(mesh, 0.1);
    const auto moved = [](TriangleMesh m) {
        for (Vec3& p : m.positions)
            p = Vec3(p.y(), p.z(), p.x()) + Vec3(10, -20, 30); // the box keeps its sides
        return m;
    };
    CHECK(distance(moved(mesh), moved(rough)) == doctest::Approx(distance(mesh, rough)).epsilon(1e-6));
}

TEST_CASE("roughness hides noise: the same noise is seen less where the surface was rough before") {
    const TriangleMesh mesh = shapes::blob(20000, 1);
    const std::vector<Vec3> normals = vertex_normals(mesh);
    const double unit = surface_box(mesh).diagonal() / 100;
    TriangleMesh ground = mesh, noisy = mesh;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const double roughness = mesh.positions[v][2] > 0 ? (v % 3 == 0 ? 0.4 : -0.2) : 0;
        const double noise = (v * 2654435761U >> 16) % 2 == 0 ? 0.03 : -0.03;
        ground.positions[v] += roughness * unit * normals[v];
        noisy.positions[v] = ground.positions[v] + noise * unit * normals[v];
    }
    const std::vector<double> local = field(ground, noisy);
    double rough = 0, smooth = 0;
    std::size_t rough_count = 0, smooth_count = 0;
    for (std::size_t v = 0; v < local.size(); ++v) {
        if (std::abs(mesh.positions[v][2]) < 0.1)
            continue; // between the halves
        (mesh.positions[v][2] > 0 ? rough : smooth) += local[v];
        ++(mesh.positions[v][2] > 0 ? rough_count : smooth_count);
    }
    CHECK(rough / static_cast<double>(rough_count) < 0.7 * smooth / static_cast<double>(smooth_count));
}

TEST_CASE("local distances say where") {
    const TriangleMesh mesh = shapes::blob(20000, 1);
    TriangleMesh half = roughened(mesh, 0.1);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        if (mesh.positions[v][2] > 0)
            half.positions[v] = mesh.positions[v];
    const std::vector<double> local = field(mesh, half);
    double above = 0, below = 0;
    for (std::size_t v = 0; v < local.size(); ++v)
        (mesh.positions[v][2] > 0.1 ? above : below) += local[v];
    CHECK(above < 0.01 * below);
    CHECK(*std::max_element(local.begin(), local.end()) < 1.2); // (1 + 1 + 0.5 * 2) / 2.5
}
