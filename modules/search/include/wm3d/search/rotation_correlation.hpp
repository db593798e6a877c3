// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The correlation of two functions on the sphere over all rotations at once.
#pragma once

#include <complex>
#include <cstddef>
#include <functional>
#include <memory>
#include <span>

#include <wm3d/search/harmonics.hpp>

namespace wm3d::search {

/// T(R) = integral of f(d) w(R d), for every rotation R = Rz(alpha) Ry(beta) Rz(gamma) of a grid of angles:
/// T = sum over l, m, m' of conj(w_lm) f_lm' d^l_mm'(beta) exp(-i (m alpha + m' gamma)), a sum over l and a
/// Fourier transform over two angles (P. Kostelec, D. Rockmore, "FFTs on the rotation group", J. Fourier
/// Anal. Appl. 14, 2008). The sums over l take real symmetry and those of d^l under transposition and under
/// beta -> pi - beta into account; angles beta and pi - beta are the real and the imaginary part of one transform.
template<typename Real>
class RotationCorrelation {
public:
    /// \param bandwidth  degrees below it count
    /// \param samples    of each angle; even and at least twice the bandwidth
    RotationCorrelation(unsigned bandwidth, unsigned samples);
    ~RotationCorrelation();
    RotationCorrelation(RotationCorrelation&&) noexcept;
    RotationCorrelation& operator=(RotationCorrelation&&) noexcept;

    unsigned samples() const;

    /// The rotation at alpha = 2 pi a / samples, beta = pi (b + 1/2) / samples, gamma = 2 pi c / samples.
    Mat3 rotation(std::size_t a, std::size_t b, std::size_t c) const;

    /// Called with the number of a function and each b below samples / 2, in no order to rely on, and T of all (a, c),
    /// number a * samples + c: real parts are those of b, imaginary parts those of samples - 1 - b.
    using Visit =
        std::function<void(std::size_t f, std::size_t b, std::span<const std::complex<Real>> values)>;

    /// Correlates each of the functions f with w, on the calling thread. A few together take less time than
    /// one after the other: what all need of d^l_mm' is larger than a processor's caches.
    /// \pre  f and w have at least the bandwidth
    void operator()(std::span<const Harmonics> f, const Harmonics& w, const Visit& visit) const;

private:
    struct Tables;
    std::unique_ptr<Tables> tables_;
};

/// Standard deviation of T over functions w with the power of this one in each degree.
double spread(const Harmonics& f, const Harmonics& w);

extern template class RotationCorrelation<float>;
extern template class RotationCorrelation<double>;

} // namespace wm3d::search
