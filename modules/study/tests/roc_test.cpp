// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/study/roc.hpp>

#include <array>
#include <cmath>
#include <vector>

#include <doctest/doctest.h>

#include <wm3d/study/paper_roc.hpp>

using namespace wm3d;
using namespace wm3d::study;

TEST_CASE("Clopper-Pearson intervals match the beta quantiles that define them") {
    // scipy.stats.beta.ppf(0.025, k, n - k + 1) and ppf(0.975, k + 1, n - k)
    const MeasuredPoint some = measured_point(1e-6, 3, 20);
    CHECK(some.pm == doctest::Approx(0.15));
    CHECK(some.low == doctest::Approx(0.0320709371854637).epsilon(1e-9));
    CHECK(some.high == doctest::Approx(0.37892682654531396).epsilon(1e-9));
    const MeasuredPoint none = measured_point(1e-6, 0, 200), all = measured_point(1e-6, 200, 200);
    CHECK(none.low == 0);
    CHECK(none.high == doctest::Approx(1 - std::pow(0.025, 1.0 / 200)).epsilon(1e-12)); // the closed form
    CHECK(all.low == doctest::Approx(std::pow(0.025, 1.0 / 200)).epsilon(1e-12));
    CHECK(all.high == 1);
}

TEST_CASE("the paper's curve falls with P_f, gamma and n") {
    const std::array pf{1e-12, 1e-6, 1e-3};
    const PaperModel bunny{0.032, 0.1};
    const RocCurve weak = paper_roc(bunny, 0.1, 2500, pf), strong = paper_roc(bunny, 0.2, 2500, pf),
                   fine = paper_roc(bunny, 0.1, 10000, pf);
    for (std::size_t i = 0; i < pf.size(); ++i) {
        CHECK(strong.points[i].log10_pm < weak.points[i].log10_pm);
        CHECK(fine.points[i].log10_pm < weak.points[i].log10_pm);
        if (i > 0)
            CHECK(weak.points[i].log10_pm < weak.points[i - 1].log10_pm);
    }
}

TEST_CASE("where radii are independent of their place the true curve is the paper's") {
    // One sphere vertex per base vertex: rho is a sum of independent terms, as the paper assumes.
    detect::PaperStatistics s;
    s.n = 4000;
    s.mu_r = 1;
    std::vector<double> c(s.n);
    for (std::size_t i = 0; i < s.n; ++i) {
        const double deviation = i % 2 == 0 ? 0.1 : -0.1;
        c[i] = deviation / static_cast<double>(s.n);
    }
    s.sigma_r2 = 0.01;
    const double rmax = 0.1;
    s.delta_mean_square = rmax * rmax / 3;
    const std::array pf{1e-4, 1e-2, 0.3};
    const RocCurve model = paper_roc(s, 0.1, pf), real = true_paper_roc(s, {c, rmax}, 0.1, pf);
    for (std::size_t i = 0; i < pf.size(); ++i)
        CHECK(real.points[i].log10_pm == doctest::Approx(model.points[i].log10_pm).epsilon(5e-3));
}
