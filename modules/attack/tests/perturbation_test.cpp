// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/attack/perturbation.hpp>

#include <cmath>
#include <set>

#include <doctest/doctest.h>
#include <wm3d/attack/random.hpp>
#include <wm3d/shapes.hpp>

#include "meshes.hpp"

using namespace wm3d;
using namespace wm3d::attack;
using namespace wm3d::attack::test;

TEST_CASE("the random numbers are those of their counter and uniform") {
    const RandomStream random(1, 2);
    double sum = 0, squares = 0;
    std::array<int, 7> seen{};
    constexpr int count = 100000;
    for (std::uint64_t i = 0; i < count; ++i) {
        const double u = random.between(i, -1, 1);
        REQUIRE(std::abs(u) <= 1);
        sum += u;
        squares += u * u;
        ++seen[random.below(i, 7)];
    }
    CHECK(std::abs(sum / count) < 5 * std::sqrt(1.0 / 3 / count)); // five standard errors
    CHECK(squares / count == doctest::Approx(1.0 / 3).epsilon(0.01));
    for (int n : seen)
        CHECK(n == doctest::Approx(count / 7.0).epsilon(0.05));
    CHECK(random.word(5) == RandomStream(1, 2).word(5));
    CHECK(random.word(5) != RandomStream(1, 3).word(5));
    CHECK(random.word(5) != RandomStream(2, 2).word(5));
}

TEST_CASE("d is the mean distance to the mean vertex") {
    CHECK(mean_vertex_distance(shapes::sphere(2, 12)) == doctest::Approx(2).epsilon(1e-12));
    CHECK(mean_vertex_distance(TriangleMesh{}) == 0);
}

TEST_CASE("noise is uniform in its bounds and free of bias") {
    const TriangleMesh mesh = shapes::sphere(2, 60); // d = 2
    const TriangleMesh noisy = add_noise(mesh, 0.5, 11);
    const double amplitude = 0.005 * 2;
    double sum = 0, squares = 0;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const Vec3 move = noisy.positions[v] - mesh.positions[v];
        REQUIRE(move.cwiseAbs().maxCoeff() <= amplitude * (1 + 1e-12));
        sum += move.sum();
        squares += move.squaredNorm();
    }
    const auto count = static_cast<double>(3 * mesh.positions.size());
    CHECK(std::abs(sum / count) < 5 * amplitude / std::sqrt(3 * count));
    CHECK(squares / count == doctest::Approx(amplitude * amplitude / 3).epsilon(0.03));
    CHECK(noisy.triangles == mesh.triangles);
}

TEST_CASE("noise keeps the border") {
    const TriangleMesh mesh = shapes::square(1, 10);
    const TriangleMesh noisy = add_noise(mesh, 1, 3);
    std::size_t kept = 0;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        kept += noisy.positions[v] == mesh.positions[v];
    CHECK(kept == 40);
}

TEST_CASE("quantization leaves at most 2^bits + 1 levels per axis and moves by half a step at most") {
    const TriangleMesh mesh = shapes::blob(8000, 4);
    const Box box = bounding_box(mesh.positions);
    for (int bits : {4, 7, 11}) {
        const TriangleMesh rounded = quantize(mesh, bits);
        const Vec3 step = (box.max - box.min) / std::exp2(bits);
        for (int k = 0; k < 3; ++k) {
            std::set<double> levels;
            for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
                levels.insert(rounded.positions[v][k]);
                REQUIRE(std::abs(rounded.positions[v][k] - mesh.positions[v][k]) <= step[k] * 0.5000001);
            }
            CHECK(levels.size() <= static_cast<std::size_t>(std::exp2(bits)) + 1);
            CHECK(levels.size() > 10);
        }
    }
}

TEST_CASE("a flat axis survives quantization") {
    const TriangleMesh flat = shapes::square(1, 4);
    for (const Vec3& p : quantize(flat, 3).positions)
        CHECK(p[2] == 0);
}

TEST_CASE("rounding to decimals") {
    const TriangleMesh mesh{{{0.12345, -1.5, 2.0005}, {1, 0, 0}, {0, 1, 0}}, {{0, 1, 2}}};
    CHECK((round_decimals(mesh, 2).positions[0] - Vec3(0.12, -1.5, 2.0)).norm() < 1e-15);
}
