// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/sphere/sparse_rows.hpp>

#include <cmath>
#include <numeric>

#include <doctest/doctest.h>
#include <wm3d/core/error.hpp>
#include <wm3d/sphere/bumped_sphere.hpp>

#include "directions.hpp"

using namespace wm3d;
using namespace wm3d::sphere;

TEST_CASE("B w is the linear part of Delta") {
    const Icosphere sphere(4);
    const std::vector<Vec3> directions = random_directions(3000, 8);
    const std::vector<double> w = random_heights(sphere.vertices().size(), 0.1, 8);
    const SparseRows b = barycentric_rows(sphere, directions);
    const std::vector<double> product = multiply(b, w);
    CHECK(b.rows() == directions.size());
    CHECK(b.columns == w.size());
    for (std::size_t i = 0; i < directions.size(); ++i)
        CHECK(product[i] == linear_delta(sphere.locate(directions[i]), w));
}

TEST_CASE("multiply and multiply_transposed are adjoint") {
    const Icosphere sphere(3);
    const SparseRows b = barycentric_rows(sphere, random_directions(2000, 4));
    const std::vector<double> w = random_heights(b.columns, 1, 1), y = random_heights(b.rows(), 1, 2);
    const std::vector<double> bw = multiply(b, w), bty = multiply_transposed(b, y);
    CHECK(std::abs(std::inner_product(y.begin(), y.end(), bw.begin(), 0.0) -
                   std::inner_product(w.begin(), w.end(), bty.begin(), 0.0)) < 1e-12);
}

TEST_CASE("no directions give no rows") {
    const SparseRows b = barycentric_rows(Icosphere(2), {});
    CHECK(b.rows() == 0);
    CHECK(multiply_transposed(b, {}) == std::vector<double>(b.columns, 0.0));
}

TEST_CASE("the rows of coarser levels are those of the coarser spheres") {
    const std::vector<Vec3> directions{
        {1, 0.2, -0.3}, {0, 0, 1}, {-0.4, 0.7, 0.1}, {0.3, -0.9, 0.5}, {0, -1, 0}};
    const std::vector<unsigned> levels{1, 3, 4};
    const std::vector<SparseRows> together = barycentric_rows(Icosphere(4), directions, levels);
    for (std::size_t l = 0; l < levels.size(); ++l) {
        const Icosphere own(levels[l]);
        const SparseRows alone = barycentric_rows(own, directions);
        CHECK(together[l].columns == alone.columns);
        for (std::size_t i = 0; i < directions.size(); ++i) {
            // On an edge another face may be found: compare the points.
            Vec3 a = Vec3::Zero(), b = Vec3::Zero();
            for (std::size_t k = 0; k < 3; ++k) {
                a += together[l].weights[i][k] * own.vertices()[together[l].indices[i][k]];
                b += alone.weights[i][k] * own.vertices()[alone.indices[i][k]];
            }
            CHECK((a - b).norm() < 1e-12);
        }
    }
    const std::vector<unsigned> finer{5};
    CHECK_THROWS_AS(barycentric_rows(Icosphere(4), directions, finer), ParameterError);
}
