// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/study/response.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <wm3d/core/parallel.hpp>
#include <wm3d/detect/normal_orthant.hpp>
#include <wm3d/detect/tail.hpp>

namespace wm3d::study {

namespace {

/// Keys of pilot marks: a family that no trial draws from.
constexpr std::uint64_t pilot_seed = 0x70696c6f74;

double dot(std::span<const double> a, std::span<const double> b) {
    double sum = 0;
    for (std::size_t j = 0; j < a.size(); ++j)
        sum += a[j] * b[j];
    return sum;
}

/// Covariance of c.w between filters over random keys.
Eigen::MatrixXd host_covariance(const std::vector<detect::LinearStatistic>& host) {
    const auto n = static_cast<Eigen::Index>(host.size());
    Eigen::MatrixXd covariance(n, n);
    for (Eigen::Index f = 0; f < n; ++f)
        for (Eigen::Index g = 0; g < n; ++g) {
            const detect::LinearStatistic &a = host[static_cast<std::size_t>(f)],
                                          &b = host[static_cast<std::size_t>(g)];
            covariance(f, g) = a.rmax() * b.rmax() / 3 * dot(a.coefficients(), b.coefficients());
        }
    return covariance;
}

Eigen::VectorXd mean_of(const std::vector<Eigen::VectorXd>& x) {
    Eigen::VectorXd mean = Eigen::VectorXd::Zero(x.front().size());
    for (const Eigen::VectorXd& row : x)
        mean += row / static_cast<double>(x.size());
    return mean;
}

/// Covariance of the m of another key, as far as these tell it, and of their mean: that is unknown as well.
Eigen::MatrixXd mark_covariance(const std::vector<Eigen::VectorXd>& mark, const Eigen::VectorXd& mean) {
    const auto count = static_cast<double>(mark.size());
    Eigen::MatrixXd covariance = Eigen::MatrixXd::Zero(mean.size(), mean.size());
    for (const Eigen::VectorXd& m : mark)
        covariance += (m - mean) * (m - mean).transpose();
    return mark.size() > 1 ? (1 + 1 / count) / (count - 1) * covariance : covariance;
}

/// Thresholds of the standardized scores: the exact null quantile at each hypothesis' share of P_f.
Eigen::VectorXd thresholds(const Response& response, double pf) {
    const double log10_share = std::log10(pf) - std::log10(static_cast<double>(response.hypotheses));
    Eigen::VectorXd limit(static_cast<Eigen::Index>(response.host.size()));
    for (Eigen::Index f = 0; f < limit.size(); ++f) {
        const detect::LinearStatistic& c = response.host[static_cast<std::size_t>(f)];
        limit[f] = detect::tail_quantile(c, log10_share) / c.sigma();
    }
    return limit;
}

} // namespace

std::vector<watermark::Marked> pilot_marks(const TrialBench& bench, double size, std::size_t count,
                                           const Progress& progress) {
    std::vector<watermark::Marked> marks(count);
    notify(progress, "trying marks", 0);
    parallel_tasks(count, [&](std::size_t k) { marks[k] = bench.mark(size, pilot_seed, k); });
    return marks;
}

Response pilot_response(const TrialBench& bench, const std::vector<watermark::Marked>& pilots,
                        const Progress& progress) {
    Response response;
    response.host = bench.host();
    response.hypotheses = bench.hypotheses();
    std::vector<Trial> trials(pilots.size());
    parallel_tasks(pilots.size(),
                   [&](std::size_t k) { trials[k] = bench.examine(pilots[k], pilot_seed, k); });
    notify(progress, "trying marks", 1);
    for (Trial& trial : trials) {
        response.mark.push_back(std::move(trial.mark));
        response.variance.push_back(std::move(trial.variance));
        const double share = 1 / static_cast<double>(pilots.size());
        response.gamma += share * trial.gamma;
        response.distortion.normal_rms += share * trial.distortion.normal_rms;
        response.distortion.vertex_rms += share * trial.distortion.vertex_rms;
        response.distortion.max += share * trial.distortion.max;
    }
    return response;
}

double log10_miss(const Response& response, double factor, double pf) {
    const Eigen::VectorXd mark = mean_of(response.mark), mean = factor * mark;
    const Eigen::MatrixXd host = host_covariance(response.host);
    const Eigen::VectorXd sigma = (host.diagonal() + factor * factor * mean_of(response.variance))
                                      .cwiseMax(1e-3 * host.diagonal())
                                      .cwiseSqrt();
    const Eigen::MatrixXd covariance = host + factor * factor * mark_covariance(response.mark, mark);
    const Eigen::VectorXd unit = sigma.cwiseInverse();
    const double by_chance = static_cast<double>(response.hypotheses - response.host.size()) *
                             std::log1p(-pf / static_cast<double>(response.hypotheses)) / std::numbers::ln10;
    return by_chance + detect::log10_normal_orthant(mean.cwiseProduct(unit),
                                                    unit.asDiagonal() * covariance * unit.asDiagonal(),
                                                    thresholds(response, pf));
}

} // namespace wm3d::study
