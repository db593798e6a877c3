// SPDX-License-Identifier: GPL-3.0-or-later
// Eq. (2): Pi^-1(p) = alpha p_i + beta p_j + gamma p_k with p = alpha Pi(p_i) + beta Pi(p_j) + gamma Pi(p_k).
#include <wm3d/maps.hpp>

#include "support/triangles.hpp"
#include "support/vectors.hpp"

using namespace wm3d;

namespace {

/// The point of the base triangle over the given input vertices with one coordinate for each of these.
SurfacePoint base_point(const maps::BaseDomain& domain, const std::array<Index, 3>& corners,
                        const Vec3& barycentric) {
    SurfacePoint point;
    for (Index t = 0; t < domain.mesh.triangles.size(); ++t) {
        int matched = 0;
        Vec3 weights = Vec3::Zero();
        for (std::size_t k = 0; k < 3; ++k)
            for (std::size_t c = 0; c < 3; ++c)
                if (domain.original[domain.mesh.triangles[t][k]] == corners[c]) {
                    weights[static_cast<int>(k)] = barycentric[static_cast<int>(c)];
                    ++matched;
                }
        if (matched == 3)
            point = {t, weights};
    }
    return point;
}

} // namespace

TEST_CASE("the inverse map combines the originals as p combines their images") {
    spec::Vectors("eq_02.json").each([](const spec::Vector& vector) {
        if (!vector.expects("original_point"))
            return;
        vector.check("original_point", spec::list(maps::original_point(spec::point(vector, "p"),
                                                                       spec::corners(vector, "images"),
                                                                       spec::corners(vector, "originals"))));
    });
}

TEST_CASE("points of the base domain go back to the surface") {
    std::size_t returned = 0;
    spec::Vectors("eq_02.json").each([&](const spec::Vector& vector) {
        if (!vector.expects("surface_point"))
            return;
        const TriangleMesh mesh{spec::points(vector, "positions"),
                                vector.input<std::vector<Triangle>>("triangles")};
        simplify::Options options;
        options.target_vertices = mesh.positions.size() - 1;
        const maps::BaseDomain domain = maps::parameterize(mesh, options);
        const maps::InverseMap inverse(mesh, domain);
        const std::vector<Vec3> queries = spec::points(vector, "queries");
        for (std::size_t i = 0; i < queries.size(); ++i, ++returned) {
            const SurfacePoint query =
                base_point(domain, vector.input<std::array<Index, 3>>("corners"), queries[i]);
            REQUIRE(query.triangle != no_index);
            vector.check_row("surface_point", i, spec::list(inverse.to_surface(query)));
        }
    });
    CHECK(returned == 12);
}
