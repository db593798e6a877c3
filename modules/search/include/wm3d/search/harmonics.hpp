// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Spherical harmonics of real functions and of weighted points on the sphere.
#pragma once

#include <complex>
#include <functional>
#include <memory>
#include <span>
#include <vector>

#include <wm3d/mesh/types.hpp>

namespace wm3d::search {

/// Coefficients f_lm = integral of f times the conjugate of Y_lm of a real function, degrees 0 to
/// bandwidth - 1. Y_lm is orthonormal, with the phase of Condon and Shortley. Orders below 0 follow from
/// f_l,-m = (-1)^m conj(f_lm) and aren't stored.
struct Harmonics {
    unsigned bandwidth = 0;
    std::vector<std::complex<double>> coefficients; ///< number l (l + 1) / 2 + m, 0 <= m <= l

    explicit Harmonics(unsigned b) : bandwidth(b), coefficients(std::size_t{b} * (b + 1) / 2) {}

    std::complex<double>& operator()(unsigned l, unsigned m) {
        return coefficients[std::size_t{l} * (l + 1) / 2 + m];
    }
    const std::complex<double>& operator()(unsigned l, unsigned m) const {
        return coefficients[std::size_t{l} * (l + 1) / 2 + m];
    }

    /// Sum of |f_lm|^2 over the orders -l to l of each degree, #bandwidth.
    std::vector<double> power() const;

    /// The function that takes at d what this one takes at -d.
    Harmonics inverted() const;

    /// Each degree times a factor of its own, #bandwidth.
    Harmonics weighted(std::span<const double> factors) const;
};

/// sum_i q_i conj(Y_lm(d_i)), term by term: exact, and slow. The lengths of the directions don't matter.
Harmonics direct_harmonics(std::span<const Vec3> directions, std::span<const double> q, unsigned bandwidth);

/// The sum of f_lm Y_lm at a direction.
double evaluate(const Harmonics& f, const Vec3& direction);

/// The same coefficients by a grid of rings around the z axis: points are spread over the four by four grid
/// places around them (the transpose of cubic interpolation), rings transformed by FFT.
class HarmonicTransform {
public:
    /// \param rings  at least 2 bandwidth, even; with 4 bandwidth points lose less than a percent at the
    /// highest degrees
    HarmonicTransform(unsigned bandwidth, unsigned rings);
    explicit HarmonicTransform(unsigned bandwidth) : HarmonicTransform(bandwidth, 4 * bandwidth) {}
    ~HarmonicTransform();
    HarmonicTransform(HarmonicTransform&&) noexcept;
    HarmonicTransform& operator=(HarmonicTransform&&) noexcept;

    unsigned bandwidth() const;

    /// About sum_i q_i conj(Y_lm(d_i)). Directions of no length are left out.
    Harmonics of_points(std::span<const Vec3> directions, std::span<const double> q) const;

    /// Harmonics of a function by quadrature over the grid, exact where f has no degrees from rings / 2 on.
    /// `f` is called for many directions at the same time.
    Harmonics of_function(const std::function<double(const Vec3&)>& f) const;

private:
    struct Tables;
    std::unique_ptr<Tables> tables_;
};

} // namespace wm3d::search
