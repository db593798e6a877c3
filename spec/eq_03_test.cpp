// SPDX-License-Identifier: GPL-3.0-or-later
// Eq. (3): r_w = r + gamma (R_P - R) = r + gamma Delta.
#include <wm3d/embed.hpp>
#include <wm3d/key.hpp>
#include <wm3d/sphere.hpp>

#include "support/triangles.hpp"
#include "support/vectors.hpp"

using namespace wm3d;

namespace {

sphere::BumpedSphere sphere_of(const spec::Vector& vector) {
    return {sphere::Icosphere(vector.input<unsigned>("level")), vector.input<std::vector<double>>("heights"),
            vector.input("radius")};
}

} // namespace

TEST_CASE("W has one height per vertex of the sphere, at every level") {
    CHECK(key::max_level == sphere::max_level);
    for (unsigned level = 0; level <= sphere::max_level; ++level)
        CHECK(key::sequence_length(level) == sphere::Icosphere(level).vertices().size());
}

TEST_CASE("R_P and Delta are those of the ray and the bumped mesh") {
    spec::Vectors("eq_03.json").each([](const spec::Vector& vector) {
        const sphere::BumpedSphere bumped = sphere_of(vector);
        std::vector<double> radius, linear;
        for (const Vec3& direction : spec::points(vector, "directions")) {
            radius.push_back(bumped.radius_at(direction));
            linear.push_back(sphere::linear_delta(bumped.sphere().locate(direction), bumped.heights()));
        }
        vector.check("bumped_radius", radius);
        vector.check("linear_delta", linear);
        vector.check("delta", bumped.deltas(spec::points(vector, "directions")));
    });
}

TEST_CASE("a marked radius is r + gamma Delta") {
    spec::Vectors("eq_03.json").each([](const spec::Vector& vector) {
        const std::vector<double> delta = sphere_of(vector).deltas(spec::points(vector, "directions"));
        const auto r = vector.input<std::vector<double>>("r");
        std::vector<double> marked;
        for (std::size_t i = 0; i < r.size(); ++i)
            marked.push_back(embed::marked_radius(r[i], vector.input("gamma"), delta[i]));
        vector.check("marked_radius", marked);
    });
}

TEST_CASE("a marked vertex keeps its direction and gets its marked radius") {
    spec::Vectors("eq_03.json").each([](const spec::Vector& vector) {
        const std::vector<Vec3> directions = spec::points(vector, "directions");
        const auto r = vector.input<std::vector<double>>("r");
        std::vector<Vec3> base;
        for (std::size_t i = 0; i < r.size(); ++i)
            base.push_back(r[i] * directions[i].normalized());
        const std::vector<double> delta = sphere_of(vector).deltas(directions);
        const std::vector<Vec3> marked = embed::mark_base(base, delta, vector.input("gamma"));
        REQUIRE(marked.size() == base.size());
        for (std::size_t i = 0; i < base.size(); ++i) {
            INFO(vector.id(), ", vertex ", i);
            CHECK(
                marked[i].norm() ==
                doctest::Approx(embed::marked_radius(r[i], vector.input("gamma"), delta[i])).epsilon(1e-15));
            CHECK(marked[i].normalized().dot(base[i].normalized()) == doctest::Approx(1).epsilon(1e-15));
        }
    });
}
