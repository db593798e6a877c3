// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/detect/paper_null.hpp>

#include <wm3d/detect/tail.hpp>

namespace wm3d::detect {

LinearStatistic paper_statistic(std::span<const double> radius, const sphere::SparseRows& rows, double rmax) {
    const auto n = static_cast<double>(radius.size());
    double mu_r = 0;
    for (double r : radius)
        mu_r += r / n;
    std::vector<double> deviation(radius.size());
    for (std::size_t i = 0; i < radius.size(); ++i)
        deviation[i] = (radius[i] - mu_r) / n;
    return {sphere::multiply_transposed(rows, deviation), rmax};
}

double log10_true_pf(const LinearStatistic& statistic, const PaperStatistics& paper, double pf) {
    const double above_mean = threshold(pf, paper.n, paper.sigma_r2, paper.delta_mean_square, 0, 0);
    return exact_tail(statistic, above_mean).log10_p;
}

} // namespace wm3d::detect
