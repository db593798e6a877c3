// SPDX-License-Identifier: GPL-3.0-or-later
// Eq. (4): rho = (1/n) sum r_i Delta_i.
#include <wm3d/detect/paper.hpp>

#include "support/vectors.hpp"

using namespace wm3d;

TEST_CASE("rho is the mean of the products") {
    spec::Vectors("eq_04.json").each([](const spec::Vector& vector) {
        const auto r = vector.input<std::vector<double>>("r"),
                   delta = vector.input<std::vector<double>>("delta");
        vector.check("correlation", detect::correlation(r, delta));
    });
}
