// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/mesh/weld.hpp>

#include <bit>
#include <cmath>

#include <doctest/doctest.h>

#include <wm3d/core/split_mix.hpp>

using namespace wm3d;

namespace {

/// The word that split_mix_finalizer makes this one of.
std::uint64_t unmixed(std::uint64_t z) {
    z = (z ^ (z >> 31) ^ (z >> 62)) * 0x319642b2d24d8ec3u;
    z = (z ^ (z >> 27) ^ (z >> 54)) * 0x96de1b173f119089u;
    return z ^ (z >> 30) ^ (z >> 60);
}

/// Different points that all have one hash.
std::vector<Vec3> points_of_one_hash(std::size_t count) {
    std::vector<Vec3> points;
    for (double x = 1; points.size() < count; ++x) {
        std::uint64_t h = split_mix_finalizer(split_mix_step ^ std::bit_cast<std::uint64_t>(x));
        h = split_mix_finalizer(h ^ std::bit_cast<std::uint64_t>(2.0));
        const auto z = std::bit_cast<double>(h ^ unmixed(42));
        if (std::isfinite(z))
            points.emplace_back(x, 2, z);
    }
    return points;
}

} // namespace

TEST_CASE("positions that coincide become one vertex, numbered by first appearance") {
    const std::vector<Vec3> positions{{0, 0, 0}, {1, 0, 0}, {0, 1, 0}, {1, 0, 0}, {1, 1, 0}, {-0.0, 1, 0}};
    const std::vector<Triangle> triangles{{0, 1, 2}, {3, 4, 5}};
    const Welded welded = weld(positions, triangles);
    CHECK(welded.mesh.positions.size() == 4);
    CHECK(welded.vertex_of == std::vector<Index>{0, 1, 2, 1, 3, 2});
    CHECK(welded.mesh.triangles == std::vector<Triangle>{{0, 1, 2}, {1, 3, 2}});
}

TEST_CASE("triangles that collapse are dropped, isolated vertices stay") {
    const std::vector<Vec3> positions{{0, 0, 0}, {1, 0, 0}, {0, 0, 0}, {5, 5, 5}};
    const std::vector<Triangle> triangles{{0, 1, 2}};
    const Welded welded = weld(positions, triangles);
    CHECK(welded.mesh.positions.size() == 3);
    CHECK(welded.mesh.triangles.empty());
}

TEST_CASE("close is not equal") {
    const std::vector<Vec3> positions{{0, 0, 0}, {1e-300, 0, 0}};
    CHECK(weld(positions, {}).mesh.positions.size() == 2);
}

TEST_CASE("points that were made to hash alike are welded as quickly as others") {
    REQUIRE(unmixed(split_mix_finalizer(1234567)) == 1234567);
    std::vector<Vec3> positions = points_of_one_hash(200000); // each with each would be minutes
    positions.insert(positions.end(), {positions[7], positions[199999], Vec3(0, 0, 0)});
    const Welded welded = weld(positions, {});
    CHECK(welded.mesh.positions.size() == 200001);
    CHECK(welded.vertex_of[7] == 7);
    CHECK(welded.vertex_of[200000] == 7);
    CHECK(welded.vertex_of[200001] == 199999);
    CHECK(welded.vertex_of[200002] == 200000);
}
