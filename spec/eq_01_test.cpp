// SPDX-License-Identifier: GPL-3.0-or-later
// Eq. (1): p^0 = alpha p_i + beta p_j + gamma p_k.
#include <algorithm>
#include <optional>

#include <wm3d/maps.hpp>

#include "support/triangles.hpp"
#include "support/vectors.hpp"

using namespace wm3d;

namespace {

/// Where the removed vertex of a vector went.
struct Removal {
    std::size_t row;                 ///< of the vector's list of triangles
    std::vector<double> barycentric; ///< of that row's corners
    Vec3 image;
};

/// Removes one vertex of the vector's mesh; nothing if another vertex went or a triangle that the vector
/// lacks.
std::optional<Removal> remove_one(const spec::Vector& vector) {
    const TriangleMesh mesh{spec::points(vector, "positions"),
                            vector.input<std::vector<Triangle>>("triangles")};
    simplify::Options options;
    options.target_vertices = mesh.positions.size() - 1;
    const maps::BaseDomain domain = maps::parameterize(mesh, options);
    const auto removed = vector.input<Index>("removed");
    if (domain.collapses != 1 || domain.clamped != 0 || std::ranges::count(domain.original, removed) != 0)
        return std::nullopt;
    const SurfacePoint& place = domain.point[removed];
    const auto rows = vector.input<std::vector<std::vector<Index>>>("corners");
    for (std::size_t row = 0; row < rows.size(); ++row) {
        std::vector<double> weights(rows[row].size(), 0.0);
        bool holds = true; // corners that the row lacks have no weight
        for (std::size_t k = 0; k < 3; ++k) {
            const Index corner = domain.original[domain.mesh.triangles[place.triangle][k]];
            const double weight = place.barycentric[static_cast<int>(k)];
            if (const auto at = std::ranges::find(rows[row], corner); at != rows[row].end())
                weights[static_cast<std::size_t>(at - rows[row].begin())] = weight;
            else
                holds = holds && weight == 0;
        }
        if (holds)
            return Removal{row, weights, maps::image(domain, removed)};
    }
    return std::nullopt;
}

} // namespace

TEST_CASE("p^0 is the combination of the corners") {
    spec::Vectors("eq_01.json").each([](const spec::Vector& vector) {
        if (vector.expects("base_point"))
            vector.check("base_point", spec::list(maps::base_point(spec::corners(vector, "corners"),
                                                                   spec::point(vector, "barycentric"))));
    });
}

TEST_CASE("barycentric coordinates are those of the nearest point of the plane") {
    spec::Vectors("eq_01.json").each([](const spec::Vector& vector) {
        if (vector.expects("barycentric_coordinates"))
            vector.check("barycentric_coordinates",
                         spec::list(maps::barycentric_coordinates(spec::point(vector, "p"),
                                                                  spec::corners(vector, "corners"))));
    });
}

TEST_CASE("a removed vertex goes where the conformal flattening of its ring puts it") {
    std::size_t removals = 0;
    spec::Vectors("eq_01.json").each([&](const spec::Vector& vector) {
        if (!vector.expects("place"))
            return;
        INFO(vector.id());
        const std::optional<Removal> removal = remove_one(vector);
        REQUIRE(removal);
        vector.check_row("place", removal->row, removal->barycentric);
        vector.check_row("image", removal->row, spec::list(removal->image));
        ++removals;
    });
    CHECK(removals == 9);
}
