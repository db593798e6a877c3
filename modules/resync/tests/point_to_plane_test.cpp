// SPDX-License-Identifier: GPL-3.0-or-later
#include "../src/point_to_plane.hpp"

#include <array>

#include <ceres/ceres.h>
#include <doctest/doctest.h>

#include "../src/solver.hpp"

using namespace wm3d;
using resync::PointToPlane;

namespace {

using Parameters = std::array<double, 8>; // quaternion x y z w, log scale, translation

double distance(const PointToPlane& term, const Parameters& x) {
    double d = 0;
    term(x.data(), x.data() + 4, x.data() + 5, &d);
    return d;
}

} // namespace

TEST_CASE("the Jacobians that Ceres derives agree with central differences") {
    const PointToPlane term{{0.4, -1.1, 0.7}, {0.2, 0.3, -0.5}, Vec3(1, 2, -1).normalized()};
    const Eigen::Quaterniond q(Eigen::AngleAxisd(1.2, Vec3(1, -1, 2).normalized()));
    const Parameters at{q.x(), q.y(), q.z(), q.w(), 0.35, -0.2, 0.9, 1.4};

    const ceres::AutoDiffCostFunction<PointToPlane, 1, 4, 1, 3> cost(new PointToPlane(term));
    Parameters derived{};
    double value = 0;
    const std::array<const double*, 3> blocks{at.data(), at.data() + 4, at.data() + 5};
    std::array<double*, 3> jacobians{derived.data(), derived.data() + 4, derived.data() + 5};
    REQUIRE(cost.Evaluate(blocks.data(), &value, jacobians.data()));
    CHECK(value == doctest::Approx(distance(term, at)).epsilon(1e-14));
    for (std::size_t k = 0; k < at.size(); ++k) {
        constexpr double step = 1e-5; // error of the difference: its square times the third derivative
        Parameters above = at, below = at;
        above[k] += step;
        below[k] -= step;
        CHECK(derived[k] ==
              doctest::Approx((distance(term, above) - distance(term, below)) / (2 * step)).epsilon(1e-8));
    }
}

TEST_CASE("a step from nearby finds the transform that the planes tell") {
    const resync::Similarity truth{Eigen::AngleAxisd(0.2, Vec3(0, 1, 1).normalized()).toRotationMatrix(), 1.1,
                                   Vec3(0.1, -0.05, 0.02)};
    std::vector<PointToPlane> terms;
    for (int i = 0; i < 60; ++i) {
        const Vec3 p(std::cos(1.0 * i), std::sin(1.7 * i), std::cos(0.3 * i + 1));
        const Vec3 n = Vec3(std::sin(2.1 * i), std::cos(0.9 * i), std::sin(0.5 * i + 2)).normalized();
        terms.push_back({p, truth(p), n});
    }
    terms.push_back({Vec3::Zero(), Vec3(30, 0, 0), Vec3::UnitX()}); // the loss has to ignore this one
    resync::Similarity found;
    for (int i = 0; i < 4; ++i)
        found = resync::solve(terms, found, 2);
    CHECK((found.matrix() - truth.matrix()).norm() < 1e-6);
}
