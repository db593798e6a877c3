// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/watermark/content_statistic.hpp>

#include <cmath>
#include <vector>

#include <Eigen/Cholesky>
#include <Eigen/Core>

namespace wm3d::watermark {

namespace {

/// Keeps filters that see nearly the same from being played off against each other.
constexpr double ridge = 0.02;

using Coefficients = Eigen::Map<const Eigen::VectorXd>;

Coefficients coefficients(const detect::LinearStatistic& statistic) {
    const std::span<const double> c = statistic.coefficients();
    return {c.data(), static_cast<Eigen::Index>(c.size())};
}

} // namespace

detect::LinearStatistic content_statistic(std::span<const detect::Hypothesis> family, std::size_t best,
                                          std::span<const double> w) {
    const detect::Hypothesis& found = family[best];
    std::vector<detect::LinearStatistic> seen;
    for (const detect::Hypothesis& h : family)
        if (h.pose == found.pose && h.level == found.level && h.statistic.sigma() > 0)
            seen.push_back(detect::own_statistic(h));
    if (seen.size() <= 1)
        return detect::own_statistic(found);

    const auto filters = static_cast<Eigen::Index>(seen.size());
    Eigen::MatrixXd unit(coefficients(found.statistic).size(), filters);
    Eigen::VectorXd t(filters);
    for (Eigen::Index f = 0; f < filters; ++f) {
        const detect::LinearStatistic& statistic = seen[static_cast<std::size_t>(f)];
        const double norm = coefficients(statistic).norm();
        unit.col(f) = coefficients(statistic) / norm;
        t(f) = statistic.value(w) / norm;
    }
    Eigen::MatrixXd gram = unit.transpose() * unit;
    gram.diagonal().array() += ridge;
    const Eigen::VectorXd blend = unit * gram.ldlt().solve(t);
    return {{blend.begin(), blend.end()}, found.statistic.rmax()};
}

} // namespace wm3d::watermark
