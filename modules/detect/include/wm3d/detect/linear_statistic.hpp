// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  A statistic that is linear in the key, and its exact distribution over random keys.
#pragma once

#include <memory>
#include <span>
#include <vector>

namespace wm3d::detect {

/// How a number of a keyed sequence is distributed over random keys.
enum class Law {
    uniform, ///< on (-height, height): the watermark sequence
    sign,    ///< -height or height, equally likely: carriers of payloads and recipients
};

/// T = sum c_j w_j with fixed c_j and independent w_j of one law. The coefficients come from the suspect
/// alone; if the key is secret and random, nothing about the suspect has to be assumed to know how T is
/// distributed.
class LinearStatistic {
public:
    /// \param rmax  height of the numbers
    /// \pre  rmax > 0
    LinearStatistic(std::vector<double> coefficients, double rmax, Law law = Law::uniform);

    std::span<const double> coefficients() const { return *coefficients_; }
    double rmax() const { return rmax_; }
    Law law() const { return law_; }

    /// T for the sequence w, #c.
    double value(std::span<const double> w) const;

    /// Standard deviation of T over random keys: rmax sqrt(sum c_j^2 / 3), for signs rmax sqrt(sum c_j^2).
    /// Zero if the suspect says nothing.
    double sigma() const { return sigma_; }

    /// Largest value T can take: rmax sum |c_j|.
    double maximum() const { return maximum_; }

private:
    std::shared_ptr<const std::vector<double>> coefficients_; ///< copies share them: a family has megabytes
    double rmax_;
    Law law_;
    double sigma_ = 0;
    double maximum_ = 0;
};

/// Cumulant generating function and its first two derivatives: K(s) = sum log(sinh(x_j) / x_j) with
/// x_j = s rmax c_j, for signs sum log cosh(x_j).
struct Cumulants {
    double k0 = 0;
    double k1 = 0;
    double k2 = 0;
};
Cumulants cumulants(const LinearStatistic& statistic, double s);

} // namespace wm3d::detect
