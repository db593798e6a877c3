// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/detect/paper.hpp>

#include <cmath>
#include <numbers>

#include <boost/math/special_functions/erf.hpp>
#include <fmt/format.h>

#include <wm3d/core/error.hpp>

namespace wm3d::detect {

namespace {

// The extended format keeps the relative error of P_m below 1e-12 where its logarithm is in the hundreds.
using Real = long double;

void require_probability(double pf) {
    if (!(pf > 0 && pf < 1))
        throw ParameterError(fmt::format(
            "the false-positive probability is {}, but it has to lie between 0 and 1, for example 1e-6", pf));
}

void require(bool holds, const char* what, double value) {
    if (!holds)
        throw ParameterError(fmt::format("{}, but it is {}", what, value));
}

/// Argument of erfc in eq. (5).
Real miss_argument(double gamma, std::size_t n, double delta_mean_square, double sigma_r, double pf) {
    require_probability(pf);
    require(n > 0, "the number of base vertices has to be positive", static_cast<double>(n));
    require(delta_mean_square >= 0 && std::isfinite(delta_mean_square),
            "the mean of Delta^2 can't be negative", delta_mean_square);
    require(sigma_r > 0 && std::isfinite(sigma_r), "the standard deviation of the radii has to be positive",
            sigma_r);
    const Real shift = Real(gamma) * std::sqrt(Real(n) * Real(delta_mean_square));
    return shift / (std::numbers::sqrt2_v<Real> * Real(sigma_r)) - boost::math::erfc_inv(2 * Real(pf));
}

/// log10 of erfc(x)/2.
double log10_half_erfc(Real x) {
    constexpr Real beyond = 100; // erfc of the extended format underflows at 106
    if (x < 0)                   // P_m is near 1: keep the digits of its distance from 1
        return static_cast<double>(std::log1p(-std::erfc(-x) / 2) / std::numbers::ln10_v<Real>);
    if (x < beyond)
        return static_cast<double>(std::log10(std::erfc(x) / 2));
    // Three terms of the asymptotic series: the first left out is below 2e-11 of the probability.
    const Real u = 1 / (2 * x * x);
    const Real series = std::log1p(-u + 3 * u * u - 15 * u * u * u);
    const Real ln = -x * x - std::log(2 * x * std::sqrt(std::numbers::pi_v<Real>)) + series;
    return static_cast<double>(ln / std::numbers::ln10_v<Real>);
}

} // namespace

double correlation(std::span<const double> radius, std::span<const double> delta) {
    if (radius.empty() || radius.size() != delta.size())
        throw ParameterError(fmt::format(
            "a correlation takes as many radii as bumps and at least one, but there are {} and {}",
            radius.size(), delta.size()));
    double sum = 0;
    for (std::size_t i = 0; i < radius.size(); ++i)
        sum += radius[i] * delta[i];
    return sum / static_cast<double>(radius.size()); // eq. (4)
}

double miss_probability(double gamma, std::size_t n, double delta_mean_square, double sigma_r, double pf) {
    const Real x = miss_argument(gamma, n, delta_mean_square, sigma_r, pf);
    return static_cast<double>(std::erfc(x) / 2); // eq. (5)
}

double log10_miss_probability(double gamma, std::size_t n, double delta_mean_square, double sigma_r,
                              double pf) {
    return log10_half_erfc(miss_argument(gamma, n, delta_mean_square, sigma_r, pf)); // eq. (5)
}

double threshold(double pf, std::size_t n, double sigma_r2, double delta_mean_square, double delta_mean,
                 double mu_r) {
    require_probability(pf);
    require(n > 0, "the number of base vertices has to be positive", static_cast<double>(n));
    require(sigma_r2 >= 0 && std::isfinite(sigma_r2), "the variance of the radii can't be negative",
            sigma_r2);
    require(delta_mean_square >= 0 && std::isfinite(delta_mean_square),
            "the mean of Delta^2 can't be negative", delta_mean_square);
    const Real spread = std::sqrt(2 * Real(sigma_r2) * Real(delta_mean_square) / Real(n));
    return static_cast<double>(spread * boost::math::erfc_inv(2 * Real(pf)) +
                               Real(mu_r) * Real(delta_mean)); // eq. (6)
}

PaperStatistics paper_statistics(std::span<const double> radius, std::span<const double> delta) {
    PaperStatistics s;
    s.rho = correlation(radius, delta);
    s.n = radius.size();
    const auto n = static_cast<double>(s.n);
    for (std::size_t i = 0; i < s.n; ++i) {
        s.mu_r += radius[i] / n;
        s.delta_mean += delta[i] / n;
        s.delta_mean_square += delta[i] * delta[i] / n;
    }
    for (double r : radius)
        s.sigma_r2 += (r - s.mu_r) * (r - s.mu_r) / n;
    return s;
}

} // namespace wm3d::detect
