// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/masking/carriers.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <doctest/doctest.h>

#include <wm3d/core/parallel.hpp>
#include <wm3d/mesh/frame.hpp>
#include <wm3d/mesh/measure.hpp>
#include <wm3d/shapes.hpp>

#include "support.hpp"

using namespace wm3d;
using masking::Carriers;
using masking::test::level;

namespace {

TriangleMesh canonical(const TriangleMesh& mesh) {
    return to_frame(mesh, canonical_frame(mesh));
}

sphere::SparseRows rows_of(const TriangleMesh& mesh) {
    return sphere::barycentric_rows(sphere::Icosphere(level), mesh.positions);
}

std::vector<double> sequence(std::uint64_t seed) {
    std::vector<double> w(10 * (std::size_t{1} << (2 * level)) + 2);
    for (double& x : w) {
        seed = seed * 6364136223846793005u + 1442695040888963407u;
        x = 0.1 * (static_cast<double>(seed >> 11) * 0x1p-52 - 1);
    }
    return w;
}

/// A blob of which the half z > 0 is rough: its vertices stand in and out by turns.
TriangleMesh half_rough() {
    TriangleMesh mesh = canonical(shapes::blob(6000, 3));
    const std::vector<double> height = sequence(17);
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        if (mesh.positions[i].z() > 0)
            mesh.positions[i] *= 1 + 0.1 * height[i % height.size()];
    return mesh;
}

} // namespace

TEST_CASE("the moves are linear in the sequence") {
    const TriangleMesh mesh = canonical(shapes::blob(4000, 7));
    const Carriers carriers(mesh);
    const sphere::SparseRows rows = rows_of(mesh);
    const std::vector<double> a = sequence(1), b = sequence(2);
    std::vector<double> sum(a.size());
    for (std::size_t j = 0; j < sum.size(); ++j)
        sum[j] = 0.3 * a[j] - 1.7 * b[j];
    const std::vector<double> of_a = carriers.moves(rows, a), of_b = carriers.moves(rows, b),
                              of_sum = carriers.moves(rows, sum);
    const double rms = carriers.rms(of_sum);
    REQUIRE(rms > 0);
    for (std::size_t i = 0; i < of_sum.size(); ++i)
        CHECK(std::abs(of_sum[i] - 0.3 * of_a[i] + 1.7 * of_b[i]) < 1e-4 * rms); // the solver's tolerance
}

TEST_CASE("rough places carry more than smooth ones") {
    const TriangleMesh mesh = half_rough();
    const Carriers carriers(mesh);
    double rough = 0, smooth = 1e9;
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        if (mesh.positions[i].z() > 0.4)
            rough = std::max(rough, carriers.mask()[i]);
        if (mesh.positions[i].z() < -0.4)
            smooth = std::min(smooth, carriers.mask()[i]);
    }
    CHECK(rough > 5 * smooth);
}

TEST_CASE("no vertex sticks out of what its neighbours do") {
    const TriangleMesh mesh = canonical(shapes::blob(6000, 3));
    const Carriers carriers(mesh);
    const std::vector<double> moves = carriers.moves(rows_of(mesh), sequence(5));
    const double rms = carriers.rms(moves);
    for (const Triangle& t : mesh.triangles)
        for (int k = 0; k < 3; ++k) {
            CHECK(std::abs(moves[t[k]]) < 8 * rms);
            CHECK(std::abs(moves[t[k]] - moves[t[(k + 1) % 3]]) < 8 * rms);
        }
}

TEST_CASE("equalizing weakens what is seen and strengthens what is not") {
    const TriangleMesh mesh = canonical(shapes::blob(4000, 7));
    Carriers carriers(mesh);
    const std::vector<double> before(carriers.mask().begin(), carriers.mask().end());
    std::vector<double> seen(before.size());
    for (std::size_t i = 0; i < seen.size(); ++i)
        seen[i] = mesh.positions[i].x() > 0 ? 0.4 : 0.025;
    std::vector<Index> all(seen.size());
    std::iota(all.begin(), all.end(), Index{0});
    carriers.equalize(all, seen, 0.1);
    for (std::size_t i = 0; i < seen.size(); ++i) {
        if (mesh.positions[i].x() > 0.3)
            CHECK(carriers.mask()[i] == doctest::Approx(0.5 * before[i]).epsilon(0.05));
        if (mesh.positions[i].x() < -0.3) // but for the limit
            CHECK(carriers.mask()[i] == doctest::Approx(2 * before[i]).epsilon(0.15));
    }
}

TEST_CASE("isolated vertices, borders and edges of three triangles are borne") {
    TriangleMesh mesh = shapes::square(1, 12);
    const auto corner = static_cast<Index>(mesh.positions.size());
    mesh.positions.emplace_back(0.1, 0.2, 0.9);
    mesh.triangles.push_back({0, 1, corner}); // a fin on the border
    mesh.positions.emplace_back(5, 5, 5);     // belongs to nothing
    mesh = canonical(mesh);
    const Carriers carriers(mesh);
    const std::vector<double> moves = carriers.moves(rows_of(mesh), sequence(9));
    CHECK(moves.back() == 0);
    for (double m : moves)
        CHECK(std::isfinite(m));
}

TEST_CASE("a polyhedron without any roughness has a finite mask") {
    const TriangleMesh mesh = canonical(shapes::box({1, 2, 3}, 6));
    const Carriers carriers(mesh);
    for (double value : carriers.mask()) {
        CHECK(std::isfinite(value));
        CHECK(value > 0);
    }
}

TEST_CASE("carriers have the same bytes at one thread and at many") {
    const TriangleMesh mesh = canonical(shapes::blob(4000, 7));
    const std::vector<double> many = Carriers(mesh).moves(rows_of(mesh), sequence(4));
    const ThreadLimit one(1);
    CHECK(Carriers(mesh).moves(rows_of(mesh), sequence(4)) == many);
}
