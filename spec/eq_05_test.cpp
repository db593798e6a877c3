// SPDX-License-Identifier: GPL-3.0-or-later
// Eq. (5): P_m = erfc((gamma sqrt(n mean(Delta^2)) - sqrt 2 erfc^-1(2 P_f) sigma_r) / (sqrt 2 sigma_r)) / 2.
#include <wm3d/detect/paper.hpp>

#include "support/vectors.hpp"

using namespace wm3d;

namespace {

template<typename Function>
double call(Function function, const spec::Vector& vector) {
    return function(vector.input("gamma"), vector.input<std::size_t>("n"), vector.input("delta_mean_square"),
                    vector.input("sigma_r"), vector.input("pf"));
}

} // namespace

TEST_CASE("P_m keeps twelve digits wherever double can say it") {
    std::size_t said = 0;
    spec::Vectors("eq_05.json").each([&](const spec::Vector& vector) {
        if (vector.expects("miss_probability")) {
            vector.check("miss_probability", call(detect::miss_probability, vector));
            ++said;
        }
    });
    CHECK(said > 40);
}

TEST_CASE("log10 P_m keeps twelve digits also where P_m underflows") {
    spec::Vectors("eq_05.json").each([](const spec::Vector& vector) {
        vector.check("log10_miss_probability", call(detect::log10_miss_probability, vector));
    });
}
