// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/detect/linear_statistic.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <Eigen/Core>

namespace wm3d::detect {

namespace {

constexpr Eigen::Index lanes = 8;
using Lanes = Eigen::Array<double, lanes, 1>;

/// Sums of the terms of K, K' and K'' for x = s a, lane by lane: log(sinh x / x), a (coth x - 1/x),
/// a^2 (1/x^2 - 1/sinh^2 x).
class UniformSums {
public:
    void add(double s, const Lanes& a) {
        const Lanes x = s * a, x2 = x * x, size = x.abs();
        const auto small = size < near_zero; // series: the closed forms cancel there
        const Lanes y = size.max(near_zero), e = (-2 * y).exp();
        const Lanes sinh_e = (1 - e) / 2; // sinh(y) exp(-y)
        const Lanes k1 = (1 + e) / (1 - e) - 1 / y;
        k0_ += small.select(x2 * (1.0 / 6 + x2 * (-1.0 / 180 + x2 * (1.0 / 2835 - x2 / 37800))), y);
        product_ *= small.select(Lanes::Ones(), sinh_e / y);
        k1_ += a * small.select(x * (1.0 / 3 + x2 * (-1.0 / 45 + x2 * (2.0 / 945 - x2 / 4725))),
                                (x < 0).select(-k1, k1));
        k2_ += a * a *
               small.select(1.0 / 3 + x2 * (-1.0 / 15 + x2 * (2.0 / 189 - x2 / 675)),
                            1 / (y * y) - e / (sinh_e * sinh_e));
        if (++factors_ == most_factors)
            take_logarithm();
    }

    Cumulants sum() {
        take_logarithm();
        return {k0_.sum(), k1_.sum(), k2_.sum()};
    }

private:
    static constexpr double near_zero = 0.1;
    static constexpr int most_factors = 8; // so that 1e-38 each would not underflow

    /// One for many factors, none of which exceeds 1.
    void take_logarithm() {
        k0_ += product_.log();
        product_.setOnes();
        factors_ = 0;
    }

    Lanes k0_ = Lanes::Zero(), k1_ = Lanes::Zero(), k2_ = Lanes::Zero(), product_ = Lanes::Ones();
    int factors_ = 0;
};

Cumulants uniform_cumulants(std::span<const double> coefficients, double rmax, double s) {
    UniformSums sums;
    for (std::size_t begin = 0; begin < coefficients.size(); begin += lanes) {
        Lanes a = Lanes::Zero(); // adds nothing
        for (std::size_t j = begin; j < std::min<std::size_t>(begin + lanes, coefficients.size()); ++j)
            a[static_cast<Eigen::Index>(j - begin)] = rmax * coefficients[j];
        sums.add(s, a);
    }
    return sums.sum();
}

/// Terms of K, K' and K'' for x = s a: log cosh x, tanh x, 1 - tanh^2 x.
Cumulants sign_cumulants(double x) {
    const double a = std::abs(x);
    const double e = std::exp(-2 * a);
    const double tanh = -std::expm1(-2 * a) / (1 + e);
    // Near 0 log cosh is x^2 / 2, which the general form loses in a difference.
    const double k0 = a < 1e-4 ? x * x / 2 : a + std::log1p(e) - std::numbers::ln2;
    return {k0, x < 0 ? -tanh : tanh, 4 * e / ((1 + e) * (1 + e))};
}

} // namespace

LinearStatistic::LinearStatistic(std::vector<double> coefficients, double rmax, Law law)
    : coefficients_(std::make_shared<const std::vector<double>>(std::move(coefficients))), rmax_(rmax),
      law_(law) {
    double squares = 0;
    for (double c : *coefficients_) {
        squares += c * c;
        maximum_ += rmax_ * std::abs(c);
    }
    sigma_ = rmax_ * std::sqrt(law_ == Law::uniform ? squares / 3 : squares);
}

double LinearStatistic::value(std::span<const double> w) const {
    // Four running sums in a fixed order: as fast as the memory, and the same bits everywhere.
    std::array<double, 4> t{};
    const std::span<const double> c = coefficients();
    const std::size_t n = c.size(), whole = n - n % 4;
    for (std::size_t j = 0; j < whole; j += 4)
        for (std::size_t k = 0; k < 4; ++k)
            t[k] += c[j + k] * w[j + k];
    for (std::size_t j = whole; j < n; ++j)
        t[0] += c[j] * w[j];
    return (t[0] + t[1]) + (t[2] + t[3]);
}

Cumulants cumulants(const LinearStatistic& statistic, double s) {
    if (statistic.law() == Law::uniform)
        return uniform_cumulants(statistic.coefficients(), statistic.rmax(), s);
    Cumulants sum;
    for (double c : statistic.coefficients()) {
        const double a = statistic.rmax() * c;
        const Cumulants term = sign_cumulants(s * a);
        sum.k0 += term.k0;
        sum.k1 += a * term.k1;
        sum.k2 += a * a * term.k2;
    }
    return sum;
}

} // namespace wm3d::detect
