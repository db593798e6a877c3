// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/search/pose.hpp>

#include <array>
#include <cmath>
#include <set>

#include <doctest/doctest.h>

#include "random_points.hpp"

using namespace wm3d;
using namespace wm3d::search;

TEST_CASE("the nearest pose of the lattice is near, and its own nearest") {
    const PoseLattice lattice;
    Numbers number(1);
    for (std::uint64_t seed = 0; seed < 200; ++seed) {
        Pose pose;
        pose.centre = 1.9 * Vec3(number(), number(), number());
        pose.turn = (seed % 2 == 0 ? 1 : -1) * random_rotation(seed);
        pose.deformation = static_cast<Deformation>(seed % 3);
        const Pose nearest = lattice.nearest(pose), again = lattice.nearest(nearest);
        CHECK((nearest.centre - pose.centre).norm() <= std::sqrt(3.0) / 2 * lattice.step + 1e-12);
        CHECK(nearest.mirrors() == pose.mirrors());
        const double angle = Eigen::AngleAxisd(Mat3(nearest.turn * pose.turn.transpose())).angle();
        CHECK(angle <= std::sqrt(3.0) * lattice.step);
        CHECK((again.centre - nearest.centre).norm() < 1e-12);
        CHECK((again.turn - nearest.turn).norm() < 1e-12);
    }
}

TEST_CASE("the lattice has no more members than it says") {
    // Many poses fall on few members of a coarse lattice; each of its dimensions is counted alone.
    PoseLattice coarse;
    coarse.step = 0.5;
    coarse.reach = 1;
    std::set<std::array<long, 10>> turns;
    for (std::uint64_t seed = 0; seed < 20000; ++seed) {
        Pose pose;
        pose.turn = (seed % 2 == 0 ? 1 : -1) * random_rotation(seed);
        const Mat3 turn = coarse.nearest(pose).turn;
        std::array<long, 10> place{};
        for (std::size_t k = 0; k < 9; ++k)
            place[k] = std::lround(1e6 * turn.reshaped()[static_cast<Eigen::Index>(k)]);
        turns.insert(place);
    }
    const double centres = 3 * std::log10(5.0); // -1, -0.5, ..., 1 along each axis
    CHECK(std::log10(static_cast<double>(turns.size())) <= coarse.log10_size(Deformation::none) - centres);
    CHECK(turns.size() > 500); // of 2 * 4 * 125, of which poses at the charts' edges coincide

    std::set<long> stretches;
    Numbers number(7);
    for (int k = 0; k < 20000; ++k) {
        Pose pose;
        pose.deformation = Deformation::affine;
        pose.stretch(0, 1) = pose.stretch(1, 0) = number();
        const Mat3 stretch = PoseLattice{}.nearest(pose).stretch;
        CHECK(std::abs(stretch(0, 1)) <= 0.1 + 1e-12);
        CHECK(std::abs(stretch.trace()) < 1e-12);
        stretches.insert(std::lround(stretch(0, 1) / 0.004));
    }
    CHECK(stretches.size() == 51);
    CHECK(PoseLattice{}.log10_size(Deformation::affine) - PoseLattice{}.log10_size(Deformation::none) ==
          doctest::Approx(5 * std::log10(51.0)));
}

TEST_CASE("a pose of no deformation turns the way from the centre") {
    Pose pose;
    pose.centre = Vec3(1, 2, 3);
    pose.turn = random_rotation(3);
    pose.bend.setOnes(); // not in force
    CHECK((pose.direction(Vec3(2, 2, 3)) - pose.turn.col(0)).norm() < 1e-15);
    CHECK(name(Deformation::bent) == "bent");
}
