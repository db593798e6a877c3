// SPDX-License-Identifier: GPL-3.0-or-later
// Eq. (6): T_rho = sqrt(2 sigma_r^2 mean(Delta^2) / n) erfc^-1(2 P_f) + mu_r mean(Delta).
#include <wm3d/detect/paper.hpp>

#include "support/vectors.hpp"

using namespace wm3d;

TEST_CASE("T_rho gives P_f in the central-limit model") {
    spec::Vectors("eq_06.json").each([](const spec::Vector& vector) {
        vector.check("threshold",
                     detect::threshold(vector.input("pf"), vector.input<std::size_t>("n"),
                                       vector.input("sigma_r2"), vector.input("delta_mean_square"),
                                       vector.input("delta_mean"), vector.input("mu_r")));
    });
}
