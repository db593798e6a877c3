// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  A statistic that is linear in the key, and its exact distribution over random keys.
#pragma once

#include <span>
#include <vector>

namespace wm3d::detect {

/// T = sum c_j w_j with fixed c_j and independent w_j, uniform in (-rmax, rmax). The coefficients come from
/// the suspect alone; if the key is secret and random, nothing about the suspect has to be assumed to know
/// how T is distributed.
class LinearStatistic {
public:
    /// \pre  rmax > 0
    LinearStatistic(std::vector<double> coefficients, double rmax);

    std::span<const double> coefficients() const { return coefficients_; }
    double rmax() const { return rmax_; }

    /// T for the sequence w, #c.
    double value(std::span<const double> w) const;

    /// Standard deviation of T over random keys: rmax sqrt(sum c_j^2 / 3). Zero if the suspect says nothing.
    double sigma() const { return sigma_; }

    /// Largest value T can take: rmax sum |c_j|.
    double maximum() const { return maximum_; }

private:
    std::vector<double> coefficients_;
    double rmax_;
    double sigma_ = 0;
    double maximum_ = 0;
};

/// Cumulant generating function K(s) = sum log(sinh(s rmax c_j) / (s rmax c_j)) and its first two
/// derivatives.
struct Cumulants {
    double k0 = 0;
    double k1 = 0;
    double k2 = 0;
};
Cumulants cumulants(const LinearStatistic& statistic, double s);

} // namespace wm3d::detect
