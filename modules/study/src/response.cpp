// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/study/response.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

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

Response pilot_response(const TrialBench& bench, double strength, std::size_t marks,
                        const Progress& progress) {
    Response response;
    response.host = bench.host();
    response.hypotheses = bench.hypotheses();
    response.strength = strength;
    std::vector<std::size_t> numbers(marks);
    std::iota(numbers.begin(), numbers.end(), 0);
    for (Trial& trial : run_trials(bench, strength, pilot_seed, numbers, {}, progress)) {
        response.mark.push_back(std::move(trial.mark));
        response.variance.push_back(std::move(trial.variance));
        const double share = 1 / static_cast<double>(marks);
        response.gamma += share * trial.gamma;
        response.distortion.normal_rms += share * trial.distortion.normal_rms;
        response.distortion.vertex_rms += share * trial.distortion.vertex_rms;
        response.distortion.max += share * trial.distortion.max;
    }
    return response;
}

double log10_miss(const Response& response, double strength, double pf) {
    const double scale = strength / response.strength;
    const auto marks = static_cast<double>(response.mark.size());
    Eigen::VectorXd mean = Eigen::VectorXd::Zero(static_cast<Eigen::Index>(response.host.size())),
                    added = mean;
    for (std::size_t k = 0; k < response.mark.size(); ++k) {
        mean += scale / marks * response.mark[k];
        added += scale * scale / marks * response.variance[k];
    }
    // T spreads as it does over random keys on the host; the marks themselves hardly differ.
    const Eigen::MatrixXd covariance = host_covariance(response.host);
    const Eigen::VectorXd sigma =
        (covariance.diagonal() + added).cwiseMax(1e-3 * covariance.diagonal()).cwiseSqrt();
    const Eigen::VectorXd unit = sigma.cwiseInverse();
    const double by_chance = static_cast<double>(response.hypotheses - response.host.size()) *
                             std::log1p(-pf / static_cast<double>(response.hypotheses)) / std::numbers::ln10;
    return by_chance + detect::log10_normal_orthant(mean.cwiseProduct(unit),
                                                    unit.asDiagonal() * covariance * unit.asDiagonal(),
                                                    thresholds(response, pf));
}

} // namespace wm3d::study
