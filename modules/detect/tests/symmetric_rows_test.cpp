// SPDX-License-Identifier: GPL-3.0-or-later
#include "../src/symmetric_rows.hpp"

#include <cmath>
#include <cstddef>

#include <doctest/doctest.h>

#include <wm3d/core/parallel.hpp>
#include <wm3d/shapes.hpp>

using namespace wm3d;
using namespace wm3d::detect;

TEST_CASE("rows of the Laplacian sum to nothing, ascend, and are symmetric") {
    const TriangleMesh mesh = shapes::torus(1, 0.4, 20, 10);
    const SymmetricRows rows = cotangent_laplacian<double>(mesh);
    const auto entry = [&](std::size_t i, Index j) {
        for (Index e = rows.start[i]; e < rows.start[i + 1]; ++e)
            if (rows.column[e] == j)
                return rows.value[e];
        return 0.0;
    };
    for (std::size_t i = 0; i < mesh.positions.size(); ++i) {
        double sum = rows.diagonal[i];
        for (Index e = rows.start[i]; e < rows.start[i + 1]; ++e) {
            sum += rows.value[e];
            CHECK(rows.value[e] == doctest::Approx(entry(rows.column[e], static_cast<Index>(i))));
            if (e > rows.start[i])
                CHECK(rows.column[e - 1] < rows.column[e]);
        }
        CHECK(std::abs(sum) < 1e-12);
    }
}

TEST_CASE(
    "a right-angled isosceles triangle has half cotangents 1/2 at its legs and next to 0 at the long side") {
    const TriangleMesh mesh{{Vec3::Zero(), Vec3::UnitX(), Vec3::UnitY()}, {{0, 1, 2}}};
    const SymmetricRowsOf<float> rows = cotangent_laplacian<float>(mesh);
    CHECK(rows.diagonal[0] == doctest::Approx(1));
    CHECK(rows.value[0] == doctest::Approx(-0.5)); // 0 to 1
    CHECK(rows.value[1] == doctest::Approx(-0.5)); // 0 to 2
    CHECK(rows.value[3] > -1e-5F);                 // 1 to 2
}

TEST_CASE("a large mesh has the same rows at one thread and at many") {
    const TriangleMesh mesh = shapes::torus(1, 0.4, 1100, 500);
    const SymmetricRowsOf<float> many = cotangent_laplacian<float>(mesh);
    const ThreadLimit one(1);
    const SymmetricRowsOf<float> told = cotangent_laplacian<float>(mesh);
    CHECK(many.start == told.start);
    CHECK(many.column == told.column);
    CHECK(many.value == told.value);
    CHECK(many.diagonal == told.diagonal);
}
