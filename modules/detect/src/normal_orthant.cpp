// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/detect/normal_orthant.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>
#include <vector>

#include <boost/math/special_functions/erf.hpp>

namespace wm3d::detect {

namespace {

constexpr std::size_t lattice_points = 2048;

/// log Phi(z).
double log_phi(double z) {
    if (z > -25)
        return std::log(std::erfc(-z / std::numbers::sqrt2) / 2);
    const double u = 1 / (z * z);
    return -z * z / 2 - std::log(-z * std::sqrt(2 * std::numbers::pi)) +
           std::log1p(u * (-1 + u * (3 - 15 * u)));
}

/// The z with Phi(z) = u Phi(b), for u in (0, 1).
double quantile_below(double u, double b) {
    if (b > -25)
        return -std::numbers::sqrt2 *
               boost::math::erfc_inv(std::max(u * std::erfc(-b / std::numbers::sqrt2), 1e-307));
    return -std::sqrt(b * b - 2 * std::log(u)); // the leading term: relative error below 1 / b^2
}

/// Cholesky factor L with L L^T = a; columns of no variance stay zero.
Eigen::MatrixXd cholesky(const Eigen::MatrixXd& a) {
    const Eigen::Index n = a.rows();
    Eigen::MatrixXd l = Eigen::MatrixXd::Zero(n, n);
    for (Eigen::Index j = 0; j < n; ++j) {
        const double pivot = a(j, j) - l.row(j).head(j).squaredNorm();
        l(j, j) = std::sqrt(std::max(pivot, 1e-12 * a(j, j)));
        for (Eigen::Index i = j + 1; i < n; ++i)
            l(i, j) = (a(i, j) - l.row(i).head(j).dot(l.row(j).head(j))) / l(j, j);
    }
    return l;
}

/// Coordinate `dimension` of lattice point k in (0, 1): multiples of an irrational number, folded so that the
/// integrand becomes periodic.
double lattice(std::size_t k, Eigen::Index dimension) {
    constexpr double primes[] = {2, 3, 5, 7, 11, 13, 17, 19, 23, 29, 31, 37};
    const double x = (static_cast<double>(k) + 0.5) * std::sqrt(primes[dimension % 12]);
    return std::abs(2 * (x - std::floor(x)) - 1);
}

/// Order of the variables, the one least likely to stay below first: then the others are conditioned on the
/// rare one.
std::vector<Eigen::Index> rarest_first(const Eigen::VectorXd& mean, const Eigen::MatrixXd& covariance,
                                       const Eigen::VectorXd& limit) {
    std::vector<Eigen::Index> order(static_cast<std::size_t>(mean.size()));
    std::iota(order.begin(), order.end(), 0);
    const auto standard = [&](Eigen::Index i) { return (limit[i] - mean[i]) / std::sqrt(covariance(i, i)); };
    std::ranges::stable_sort(order, {}, standard);
    return order;
}

} // namespace

double log10_normal_orthant(const Eigen::VectorXd& mean, const Eigen::MatrixXd& covariance,
                            const Eigen::VectorXd& limit) {
    const Eigen::Index n = mean.size();
    const std::vector<Eigen::Index> order = rarest_first(mean, covariance, limit);
    const Eigen::MatrixXd l = cholesky(covariance(order, order));
    const Eigen::VectorXd b = (limit - mean)(order);

    const double first = b[0] / l(0, 0);
    double sum = n == 1 ? static_cast<double>(lattice_points) : 0;
    Eigen::VectorXd y(n);
    for (std::size_t k = 0; n > 1 && k < lattice_points; ++k) {
        double conditional = 1, bound = first;
        for (Eigen::Index i = 1; i < n; ++i) {
            y[i - 1] = quantile_below(std::clamp(lattice(k, i - 1), 1e-15, 1 - 1e-15), bound);
            bound = (b[i] - l.row(i).head(i).dot(y.head(i))) / l(i, i);
            conditional *= std::exp(log_phi(bound));
        }
        sum += conditional;
    }
    return (log_phi(first) + std::log(sum / static_cast<double>(lattice_points))) / std::numbers::ln10;
}

} // namespace wm3d::detect
