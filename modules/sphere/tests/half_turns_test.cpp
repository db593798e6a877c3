// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/sphere/half_turns.hpp>

#include <doctest/doctest.h>

using namespace wm3d;

TEST_CASE("every vertex of every level goes to the vertex at its turned place, exactly") {
    for (unsigned level : {0u, 1u, 3u, 5u}) {
        const sphere::Icosphere sphere(level);
        const auto turns = sphere::half_turns(sphere);
        for (int axis = 0; axis < 3; ++axis)
            for (std::size_t j = 0; j < sphere.vertices().size(); ++j) {
                Vec3 expected = -sphere.vertices()[j];
                expected[axis] = sphere.vertices()[j][axis];
                const Index to = turns[static_cast<std::size_t>(axis)][j];
                REQUIRE(sphere.vertices()[to] == expected);
                REQUIRE(turns[static_cast<std::size_t>(axis)][to] == j); // twice is the identity
            }
    }
}

TEST_CASE("the turns of a coarser level begin those of a finer") {
    const auto coarse = sphere::half_turns(sphere::Icosphere(2)),
               fine = sphere::half_turns(sphere::Icosphere(4));
    for (std::size_t axis = 0; axis < 3; ++axis)
        for (std::size_t j = 0; j < coarse[axis].size(); ++j)
            CHECK(coarse[axis][j] == fine[axis][j]);
}

TEST_CASE("half turns are told from other rotations") {
    CHECK(sphere::half_turn_axis(Vec3(1, -1, -1).asDiagonal().toDenseMatrix()) == 0);
    CHECK(sphere::half_turn_axis(Vec3(-1, 1, -1).asDiagonal().toDenseMatrix()) == 1);
    CHECK(sphere::half_turn_axis(Vec3(-1, -1, 1).asDiagonal().toDenseMatrix()) == 2);
    CHECK_FALSE(sphere::half_turn_axis(Mat3::Identity()).has_value());
    CHECK_FALSE(sphere::half_turn_axis(Eigen::AngleAxisd(3, Vec3::UnitZ()).toRotationMatrix()).has_value());
}

TEST_CASE("the inversion takes every vertex to the opposite one, at every level") {
    const sphere::Icosphere fine(4);
    const std::vector<Index> opposite = sphere::inversion(fine);
    for (std::size_t j = 0; j < opposite.size(); ++j)
        CHECK(fine.vertices()[opposite[j]] == -fine.vertices()[j]);
    const std::vector<Index> coarse = sphere::inversion(sphere::Icosphere(2));
    CHECK(std::vector<Index>(opposite.begin(), opposite.begin() + static_cast<long>(coarse.size())) ==
          coarse);
}
