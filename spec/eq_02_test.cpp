// SPDX-License-Identifier: GPL-3.0-or-later
// Eq. (2): Pi^-1(p) = alpha p_i + beta p_j + gamma p_k with p = alpha Pi(p_i) + beta Pi(p_j) + gamma Pi(p_k).
#include <wm3d/maps.hpp>

#include "support/triangles.hpp"
#include "support/vectors.hpp"

using namespace wm3d;

TEST_CASE("the inverse map combines the originals as p combines their images") {
    spec::Vectors("eq_02.json").each([](const spec::Vector& vector) {
        vector.check("original_point", spec::list(maps::original_point(spec::point(vector, "p"),
                                                                       spec::corners(vector, "images"),
                                                                       spec::corners(vector, "originals"))));
    });
}
