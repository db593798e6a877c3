// SPDX-License-Identifier: GPL-3.0-or-later
#include "../src/multilevel_diffusion.hpp"

#include <cmath>
#include <numeric>

#include <doctest/doctest.h>

#include <wm3d/core/parallel.hpp>
#include <wm3d/detect/surface_filter.hpp>
#include <wm3d/mesh.hpp>
#include <wm3d/shapes.hpp>
#include <wm3d/sphere/icosphere.hpp>

using namespace wm3d;
using namespace wm3d::detect;

namespace {

constexpr int most = 1000;

std::vector<double> field(const TriangleMesh& mesh) {
    std::vector<double> x(mesh.positions.size());
    for (std::size_t i = 0; i < x.size(); ++i)
        x[i] = mesh.positions[i].normalized().x() + 0.1 * std::sin(1.7 * static_cast<double>(i));
    return x;
}

double largest_difference(const std::vector<double>& a, const std::vector<double>& b) {
    return std::inner_product(
        a.begin(), a.end(), b.begin(), 0.0, [](double x, double y) { return std::max(x, y); },
        [](double x, double y) { return std::abs(x - y); });
}

/// Steps until a residual of a millionth.
int steps(const TriangleMesh& mesh, double t) {
    const SurfaceFilter filter(mesh);
    std::vector<double> x = field(mesh);
    return MultilevelDiffusion(mesh, filter.mass()).diffuse(t, std::span(&x, 1), 1e-6, most);
}

} // namespace

TEST_CASE("levels find what conjugate gradients alone find, in any unit of length") {
    for (const double unit : {1.0, 1e30, 1e-30}) {
        TriangleMesh mesh = shapes::blob(6000, 2);
        for (Vec3& p : mesh.positions)
            p *= unit;
        const SurfaceFilter filter(mesh);
        const MultilevelDiffusion levels(mesh, filter.mass());
        for (const double t : {1e-4, 1e-2, 1.0}) {
            std::vector<double> x = field(mesh);
            const std::vector<double> expected = filter.low_pass(t * unit * unit, {x}, 1e-9).front();
            CHECK(levels.diffuse(t * unit * unit, std::span(&x, 1), 1e-9, most) < most);
            CHECK(largest_difference(x, expected) < 1e-5); // entries have seven digits
        }
    }
}

TEST_CASE("vectors that are solved for together come out as each alone") {
    const TriangleMesh mesh = shapes::blob(6000, 2);
    const SurfaceFilter filter(mesh);
    const MultilevelDiffusion levels(mesh, filter.mass());
    std::vector<double> spikes(mesh.positions.size(), 0.0), still(mesh.positions.size(), 2.0);
    for (std::size_t i = 0; i < spikes.size(); i += 50)
        spikes[i] = 1;
    std::vector<std::vector<double>> all{field(mesh), spikes, still, spikes, field(mesh)};
    const std::vector<std::vector<double>> expected = filter.low_pass(1e-3, all, 1e-9);
    levels.diffuse(1e-3, all, 1e-9, most);
    for (std::size_t k = 0; k < all.size(); ++k)
        CHECK(largest_difference(all[k], expected[k]) < 1e-5);
}

TEST_CASE("sixteen times the density takes hardly more steps") {
    const int few = steps(sphere::Icosphere(4).mesh(), 1e-2), many = steps(sphere::Icosphere(6).mesh(), 1e-2);
    CHECK(few > 2);
    CHECK(many < 3 * few); // conjugate gradients alone take four times as many
}

TEST_CASE("isolated vertices, loose triangles and folds are borne") {
    TriangleMesh mesh = shapes::blob(2000, 1);
    mesh.positions.emplace_back(5, 5, 5);
    for (int k = 0; k < 900; ++k) { // as many pieces as vertices elsewhere
        const auto first = static_cast<Index>(mesh.positions.size());
        for (const Vec3& corner : {Vec3(0, 0, 0), Vec3(0.01, 0, 0), Vec3(0, 0.01, 0)})
            mesh.positions.push_back(corner + Vec3(2, 0.02 * k, 0));
        mesh.triangles.push_back({first, first + 1, first + 2});
    }
    mesh.triangles.push_back({0, 1, 0});
    const SurfaceFilter filter(mesh);
    const MultilevelDiffusion levels(mesh, filter.mass());
    std::vector<double> x = field(mesh);
    const std::vector<double> expected = filter.low_pass(1e-3, {x}, 1e-9).front();
    levels.diffuse(1e-3, std::span(&x, 1), 1e-9, most);
    CHECK(largest_difference(x, expected) < 1e-4);
}

TEST_CASE("levels have the same bytes at any number of threads") {
    const TriangleMesh mesh = shapes::blob(30000, 1);
    const SurfaceFilter filter(mesh);
    const auto on = [&](std::size_t threads) {
        const ThreadLimit limit(threads);
        std::vector<double> x = field(mesh);
        MultilevelDiffusion(mesh, filter.mass()).diffuse(1e-3, std::span(&x, 1), 1e-6, most);
        return x;
    };
    CHECK(on(1) == on(7));
}
