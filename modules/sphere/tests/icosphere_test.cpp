// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/sphere/icosphere.hpp>

#include <algorithm>
#include <limits>

#include <doctest/doctest.h>
#include <wm3d/core/parallel.hpp>

#include "directions.hpp"

using namespace wm3d;
using namespace wm3d::sphere;

namespace {

/// Coordinates of the direction in the corners of a face, summing to 1, by solving the 3 by 3 system.
Vec3 solved(const Icosphere& sphere, std::size_t face, const Vec3& direction) {
    Mat3 corners;
    for (int k = 0; k < 3; ++k)
        corners.col(k) = sphere.vertices()[sphere.faces()[face][static_cast<std::size_t>(k)]];
    const Vec3 weights = corners.inverse() * direction;
    return weights / weights.cwiseAbs().sum(); // of the antipodal face all are negative and stay so
}

/// The face that holds the direction by the widest margin, looking at all of them.
std::size_t searched(const Icosphere& sphere, const Vec3& direction) {
    std::size_t best = 0;
    double margin = -2;
    for (std::size_t f = 0; f < sphere.faces().size(); ++f)
        if (const double least = solved(sphere, f, direction).minCoeff(); least > margin) {
            margin = least;
            best = f;
        }
    return best;
}

/// Vertices, edge midpoints, face centres, axes, and all of them pushed a hair aside.
std::vector<Vec3> degenerate_directions(const Icosphere& sphere) {
    std::vector<Vec3> directions = sphere.vertices();
    for (const Triangle& t : sphere.faces()) {
        const Vec3 &a = sphere.vertices()[t[0]], &b = sphere.vertices()[t[1]], &c = sphere.vertices()[t[2]];
        directions.insert(directions.end(), {a + b, 0.3 * b + 0.7 * c, a + b + c});
    }
    for (const Vec3 axis : {Vec3::UnitX(), Vec3::UnitY(), Vec3::UnitZ()})
        directions.insert(directions.end(), {axis, -axis});
    Numbers number(3);
    const std::size_t exact = directions.size();
    for (std::size_t i = 0; i < exact; ++i)
        directions.push_back(directions[i] + 1e-14 * Vec3(number(), number(), number()));
    return directions;
}

/// Whether the located point is what it says: coordinates of a convex combination, in the direction, on the
/// face.
bool consistent(const Icosphere& sphere, const Vec3& direction, const SphereLocation& at) {
    Vec3 point = Vec3::Zero();
    for (std::size_t k = 0; k < 3; ++k)
        point += at.barycentric[static_cast<int>(k)] * sphere.vertices()[at.vertices[k]];
    return at.vertices == sphere.faces()[at.face] && at.barycentric.minCoeff() >= 0 &&
           std::abs(at.barycentric.sum() - 1) < 4e-16 && std::abs(point.norm() - at.flat_radius) < 4e-16 &&
           (point / at.flat_radius - direction.normalized()).norm() < 4e-15;
}

} // namespace

TEST_CASE("random directions are located as by a search of all faces") {
    for (unsigned level = 0; level <= 3; ++level) {
        const Icosphere sphere(level);
        for (const Vec3& direction : random_directions(400, level)) {
            const SphereLocation at = sphere.locate(direction);
            REQUIRE(at.face == searched(sphere, direction));
            CHECK((at.barycentric - solved(sphere, at.face, direction)).norm() < 1e-12);
            CHECK(consistent(sphere, direction, at));
        }
    }
}

TEST_CASE("degenerate directions are located in a face that holds them") {
    for (unsigned level = 0; level <= 3; ++level) {
        const Icosphere sphere(level);
        bool all = true;
        for (const Vec3& direction : degenerate_directions(sphere))
            all = all && consistent(sphere, direction, sphere.locate(direction));
        CHECK(all);
    }
}

TEST_CASE("a vertex gets all the weight in its own direction, at every level") {
    for (unsigned level = 0; level <= 7; ++level) {
        const Icosphere sphere(level);
        double least = 1;
        for (Index v = 0; v < sphere.vertices().size(); ++v) {
            const SphereLocation at = sphere.locate(sphere.vertices()[v]);
            const auto corner = std::ranges::find(at.vertices, v) - at.vertices.begin();
            REQUIRE(corner < 3);
            least = std::min(least, at.barycentric[corner]);
        }
        CHECK(least > 1 - 1e-12);
    }
}

TEST_CASE("locations at the finest level are consistent") {
    const Icosphere sphere(max_level);
    bool all = true;
    for (const Vec3& direction : random_directions(20000, 99))
        all = all && consistent(sphere, direction, sphere.locate(direction));
    CHECK(all);
}

TEST_CASE("length doesn't matter, from the smallest number to the largest") {
    const Icosphere sphere(5);
    const SphereLocation expected = sphere.locate(Vec3(1, 2, -3));
    for (double scale : {0x1p-1072, 0x1p-600, 0x1p-3, 0x1p600, 0x1p1022}) {
        const SphereLocation at = sphere.locate(scale * Vec3(1, 2, -3));
        CHECK(at.face == expected.face);
        CHECK(at.barycentric == expected.barycentric);
    }
}

TEST_CASE("zero counts as +z") {
    const Icosphere sphere(4);
    CHECK(sphere.locate(Vec3::Zero()).face == sphere.locate(Vec3::UnitZ()).face);
    CHECK(sphere.locate(Vec3::Zero()).barycentric == sphere.locate(Vec3::UnitZ()).barycentric);
}

TEST_CASE("coordinates are continuous across edges") {
    const Icosphere sphere(6);
    double worst = 0;
    for (std::size_t f = 0; f < sphere.faces().size(); f += 17) {
        const Triangle& t = sphere.faces()[f];
        const Vec3 &a = sphere.vertices()[t[0]], &b = sphere.vertices()[t[1]], &c = sphere.vertices()[t[2]];
        const Vec3 middle = 0.4 * a + 0.6 * b;
        const Vec3 outwards = 1e-13 * (middle - c).normalized();
        const SphereLocation in = sphere.locate(middle - outwards), out = sphere.locate(middle + outwards);
        for (const auto& [vertex, weight] : {std::pair{t[0], 0.4}, std::pair{t[1], 0.6}})
            for (const SphereLocation& at : {in, out}) {
                const auto corner = std::ranges::find(at.vertices, vertex) - at.vertices.begin();
                REQUIRE(corner < 3);
                worst = std::max(worst, std::abs(at.barycentric[corner] - weight));
            }
    }
    CHECK(worst < 1e-11); // 1e-13 over an edge of about 0.02, times a few
}

TEST_CASE("whatever face is guessed first, the place is the same") {
    const Icosphere sphere(3);
    const auto faces = static_cast<Index>(sphere.faces().size());
    for (const Vec3& direction : random_directions(300, 11)) {
        const SphereLocation at = sphere.locate(direction), opposite = sphere.locate(-direction);
        for (const Index guess : {at.face, at.face / 4 * 4, opposite.face, faces - 1, faces, no_index}) {
            const SphereLocation guessed = sphere.locate(direction, guess);
            CHECK(guessed.face == at.face);
            CHECK(guessed.barycentric == at.barycentric);
        }
    }
    bool all = true;
    for (const Vec3& direction : degenerate_directions(sphere))
        for (const Index guess : {sphere.locate(direction).face, Index(7)})
            all = all && consistent(sphere, direction, sphere.locate(direction, guess));
    CHECK(all);
}

TEST_CASE("a list is located as its directions are, at one thread and at many") {
    const Icosphere sphere(5);
    const std::vector<Vec3> directions = random_directions(5000, 5);
    const std::vector<SphereLocation> many = sphere.locate(directions);
    const ThreadLimit one(1);
    const std::vector<SphereLocation> single = sphere.locate(directions);
    bool same = true;
    for (std::size_t i = 0; i < directions.size(); ++i) {
        const SphereLocation at = sphere.locate(directions[i]);
        for (const SphereLocation& other : {many[i], single[i]})
            same = same && at.face == other.face && at.barycentric == other.barycentric &&
                   at.flat_radius == other.flat_radius;
    }
    CHECK(same);
}
