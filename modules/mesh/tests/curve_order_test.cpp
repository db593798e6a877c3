// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/mesh/curve_order.hpp>

#include <algorithm>
#include <array>
#include <cstdlib>

#include <doctest/doctest.h>

#include <wm3d/mesh/measure.hpp>

#include "support.hpp"

using namespace wm3d;
using namespace wm3d::test;

namespace {

/// Mean difference of the numbers at the ends of an edge.
double mean_stride(const TriangleMesh& mesh) {
    double sum = 0;
    for (const Triangle& t : mesh.triangles)
        for (std::size_t k = 0; k < 3; ++k)
            sum += std::abs(static_cast<double>(t[k]) - static_cast<double>(t[(k + 1) % 3]));
    return sum / (3 * static_cast<double>(mesh.triangles.size()));
}

using Corners = std::array<std::array<double, 3>, 3>;

std::vector<Corners> sorted_triangles(const TriangleMesh& mesh) {
    std::vector<Corners> all;
    for (const Triangle& t : mesh.triangles) {
        Corners corners;
        for (std::size_t k = 0; k < 3; ++k)
            corners[k] = {mesh.positions[t[k]][0], mesh.positions[t[k]][1], mesh.positions[t[k]][2]};
        all.push_back(corners);
    }
    std::ranges::sort(all);
    return all;
}

} // namespace

TEST_CASE("the mesh along the curve is the same surface, with neighbours close by") {
    TriangleMesh mesh = shuffled_square(60);
    mesh.positions.emplace_back(1e6, 0, 0); // isolated
    const Reordered sorted = along_curve(mesh);
    CHECK(sorted_triangles(sorted.mesh) == sorted_triangles(mesh));
    CHECK(mean_stride(sorted.mesh) < 0.1 * mean_stride(mesh));
    std::vector<Index> numbers = sorted.original;
    std::ranges::sort(numbers);
    for (Index v = 0; v < numbers.size(); ++v)
        CHECK(numbers[v] == v);
    for (Index v = 0; v < numbers.size(); ++v)
        CHECK(sorted.mesh.positions[v] == mesh.positions[sorted.original[v]]);
}

TEST_CASE("a Morton code takes a bit of each axis in turn") {
    CHECK(morton_code({-0.5, -0.5, -0.5}) == 0);
    const double cell = 1.0 / (1 << morton_bits);
    CHECK(morton_code({-0.5 + 1.5 * cell, -0.5, -0.5}) == 1);
    CHECK(morton_code({-0.5, -0.5 + 1.5 * cell, -0.5}) == 2);
    CHECK(morton_code({-0.5, -0.5, -0.5 + 2.5 * cell}) == 32);
    CHECK(morton_code({9, 9, 9}) == (std::uint64_t{1} << (3 * morton_bits)) - 1);
}

TEST_CASE("a mesh of nothing stays one") {
    CHECK(along_curve({}).original.empty());
}
