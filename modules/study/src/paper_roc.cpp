// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/study/paper_roc.hpp>

#include <cmath>

#include <wm3d/detect/paper_null.hpp>
#include <wm3d/detect/tail.hpp>

namespace wm3d::study {

RocCurve paper_roc(const PaperModel& model, double gamma, std::size_t vertices, std::span<const double> pf) {
    detect::PaperStatistics s;
    s.n = vertices;
    s.sigma_r2 = model.sigma_r2;
    s.delta_mean_square = model.delta_range * model.delta_range / 3; // of a uniform number
    return paper_roc(s, gamma, pf);
}

RocCurve paper_roc(const detect::PaperStatistics& s, double gamma, std::span<const double> pf) {
    RocCurve curve{.kind = RocKind::paper, .gamma = gamma, .vertices = s.n, .points = {}};
    const double sigma_r = std::sqrt(s.sigma_r2);
    for (double p : pf)
        curve.points.push_back(
            {.pf = p,
             .pm = detect::miss_probability(gamma, s.n, s.delta_mean_square, sigma_r, p), // eq. (5)
             .log10_pm =
                 detect::log10_miss_probability(gamma, s.n, s.delta_mean_square, sigma_r, p), // eq. (5)
             .threshold = detect::threshold(p, s.n, s.sigma_r2, s.delta_mean_square, s.delta_mean,
                                            s.mu_r)}); // eq. (6)
    return curve;
}

RocCurve true_paper_roc(const detect::PaperStatistics& s, const detect::LinearStatistic& null, double gamma,
                        std::span<const double> pf) {
    RocCurve curve{.kind = RocKind::paper_true, .gamma = gamma, .vertices = s.n, .points = {}};
    const double shift = gamma * (s.delta_mean_square - s.delta_mean * s.delta_mean);
    for (double p : pf) {
        const double t = detect::tail_quantile(null, std::log10(p));
        // The null distribution is symmetric: a miss, T0 + shift < t, is as likely as T0 > shift - t.
        const double log10_pm = detect::exact_tail(null, shift - t).log10_p;
        curve.points.push_back({.pf = p,
                                .pm = std::pow(10, log10_pm),
                                .log10_pm = log10_pm,
                                .threshold = t + s.mu_r * s.delta_mean,
                                .log10_true_pf = std::log10(p)});
    }
    return curve;
}

} // namespace wm3d::study
