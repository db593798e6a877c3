// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The paper's detector: correlation, threshold and predicted miss probability (section 2.3).
/// Its probabilities rest on a central-limit model that real meshes don't follow; `paper_null` says what P_f
/// a threshold truly has.
#pragma once

#include <cstddef>
#include <span>

namespace wm3d::detect {

/// The correlation rho = (1/n) sum r_i Delta_i of the radial components of the base vertices with the bumps
/// above them, eq. (4).
/// \param radius  #n radii about the barycentre
/// \param delta   #n values R_P - R
/// \pre both have the same size
/// \throw ParameterError if they are empty
double correlation(std::span<const double> radius, std::span<const double> delta);

/// The miss probability P_m of the paper's model at false-positive probability `pf`, eq. (5).
/// \param gamma              strength of the mark
/// \param n                  number of base vertices
/// \param delta_mean_square  mean of Delta_i^2
/// \param sigma_r            standard deviation of the radii
/// \pre  0 < pf < 1, n > 0, delta_mean_square >= 0, sigma_r > 0, else ParameterError
double miss_probability(double gamma, std::size_t n, double delta_mean_square, double sigma_r, double pf);

/// log10 of `miss_probability`, also where that underflows; eq. (5).
double log10_miss_probability(double gamma, std::size_t n, double delta_mean_square, double sigma_r,
                              double pf);

/// The threshold T_rho that gives P_f in the paper's model, eq. (6). The bar in the paper's root covers the
/// squares (the mean of Delta_i^2, as in eq. (5)): that is the variance of rho.
/// \pre  0 < pf < 1, n > 0, sigma_r2 >= 0, delta_mean_square >= 0, else ParameterError
double threshold(double pf, std::size_t n, double sigma_r2, double delta_mean_square, double delta_mean,
                 double mu_r);

/// Moments that eq. (4) to (6) take from a base mesh and a key.
struct PaperStatistics {
    std::size_t n = 0;
    double rho = 0;
    double mu_r = 0;     ///< mean radius of the base vertices
    double sigma_r2 = 0; ///< variance of the radii
    double delta_mean = 0;
    double delta_mean_square = 0;
};

/// \pre  as `correlation`
PaperStatistics paper_statistics(std::span<const double> radius, std::span<const double> delta);

} // namespace wm3d::detect
