// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/search/rotation_correlation.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>
#include <vector>

#include <wm3d/core/error.hpp>
#include <wm3d/core/parallel.hpp>

#include "fftw.hpp"
#include "wigner.hpp"

namespace wm3d::search {

namespace {

using std::numbers::pi;

/// Columns of m' that are summed before they are written: one line of the cache.
constexpr std::size_t tile = 8;

/// For each of the angles, adds up d[l][angle] times the four numbers x[l]. The compiler may use wider
/// vectors where the machine has them: each angle's sum stays in the same order.
template<typename Real>
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__)
__attribute__((target_clones("avx2", "default")))
#endif
void accumulate(const Real* d, std::size_t degrees, std::size_t angles, const Real* x, Real* sums) {
    constexpr std::size_t lanes = 16;
    for (std::size_t begin = 0; begin < angles; begin += lanes) {
        std::array<Real, lanes> s0{}, s1{}, s2{}, s3{};
        for (std::size_t l = 0; l < degrees; ++l) {
            const Real* row = d + l * angles + begin;
            const Real x0 = x[4 * l], x1 = x[4 * l + 1], x2 = x[4 * l + 2], x3 = x[4 * l + 3];
            for (std::size_t k = 0; k < lanes; ++k) {
                s0[k] += row[k] * x0;
                s1[k] += row[k] * x1;
                s2[k] += row[k] * x2;
                s3[k] += row[k] * x3;
            }
        }
        std::copy_n(s0.data(), lanes, sums + begin);
        std::copy_n(s1.data(), lanes, sums + angles + begin);
        std::copy_n(s2.data(), lanes, sums + 2 * angles + begin);
        std::copy_n(s3.data(), lanes, sums + 3 * angles + begin);
    }
}

} // namespace

/// d^l_mn at all angles beta for m >= n >= 0, and the plan of the last step.
template<typename Real>
struct RotationCorrelation<Real>::Tables {
    using Complex = std::complex<Real>;
    unsigned bandwidth;
    std::size_t samples, angles;    ///< angles: samples, and some more so that they fill whole vectors
    std::vector<std::size_t> start; ///< of the block (m, n), number m (m + 1) / 2 + n
    std::vector<Real> d;            ///< blocks of (bandwidth - m) by angles
    FftwPlan<Real> angles_of_slice;

    Tables(unsigned b, unsigned n);

    std::size_t row_length() const { return samples / 2 + 1; }
    std::size_t slice_length() const { return samples * row_length(); }
    void sum_degrees(const Harmonics& f, const Harmonics& w, Complex* slices) const;

private:
    static typename Fftw<Real>::Plan plan(std::size_t samples);
    void fill_block(unsigned m, unsigned n);
    void sum_pair(const Harmonics& f, const Harmonics& w, unsigned m, unsigned n, std::vector<Real>& x,
                  Real* sums) const;
};

template<typename Real>
typename Fftw<Real>::Plan RotationCorrelation<Real>::Tables::plan(std::size_t samples) {
    const std::lock_guard lock(planner());
    const FftwArray<Real> out(samples * samples);
    const FftwArray<typename Fftw<Real>::Complex> in(samples * (samples / 2 + 1));
    const int n = static_cast<int>(samples);
    return Fftw<Real>::complex_to_real(n, n, in.get(), out.get());
}

template<typename Real>
RotationCorrelation<Real>::Tables::Tables(unsigned b, unsigned n)
    : bandwidth(b), samples(n), angles((samples + 15) / 16 * 16), angles_of_slice(plan(samples)) {
    std::size_t size = 0;
    for (unsigned m = 0; m < bandwidth; ++m)
        for (unsigned k = 0; k <= m; ++k) {
            start.push_back(size);
            size += (bandwidth - m) * angles;
        }
    d.resize(size);
    parallel_blocks(bandwidth, 1, [&](std::size_t m, std::size_t) {
        for (unsigned k = 0; k <= m; ++k)
            fill_block(static_cast<unsigned>(m), k);
    });
}

template<typename Real>
void RotationCorrelation<Real>::Tables::fill_block(unsigned m, unsigned n) {
    Real* block = d.data() + start[std::size_t{m} * (m + 1) / 2 + n];
    for (std::size_t b = 0; b < samples; ++b) {
        const double beta = pi * (static_cast<double>(b) + 0.5) / static_cast<double>(samples);
        wigner_d(bandwidth, m, n, beta,
                 [&](unsigned l, double value) { block[(l - m) * angles + b] = static_cast<Real>(value); });
    }
}

/// The sums over l for orders (m, n) and (-m, n): their real and imaginary parts, #angles each. The latter
/// come from d^l_-m,n(beta) = (-1)^(l - n) d^l_mn(pi - beta), so their angles run backwards.
template<typename Real>
void RotationCorrelation<Real>::Tables::sum_pair(const Harmonics& f, const Harmonics& w, unsigned m,
                                                 unsigned n, std::vector<Real>& x, Real* sums) const {
    const unsigned high = std::max(m, n), low = std::min(m, n);
    const double transposed = m < n && (n - m) % 2 == 1 ? -1 : 1;
    x.resize(std::size_t{4} * (bandwidth - high));
    for (unsigned l = high; l < bandwidth; ++l) {
        const std::complex<double> of_f = transposed * std::conj(f(l, n));
        const std::complex<double> positive = w(l, m) * of_f;
        const std::complex<double> negative = ((l + n + m) % 2 == 0 ? 1.0 : -1.0) * std::conj(w(l, m)) * of_f;
        Real* place = x.data() + std::size_t{4} * (l - high);
        place[0] = static_cast<Real>(positive.real());
        place[1] = static_cast<Real>(positive.imag());
        place[2] = static_cast<Real>(negative.real());
        place[3] = static_cast<Real>(negative.imag());
    }
    accumulate(d.data() + start[std::size_t{high} * (high + 1) / 2 + low], bandwidth - high, angles, x.data(),
               sums);
}

/// The conjugate of sum over l of conj(w_lm) f_lm' d^l_mm'(beta), slice by slice of beta: rows m modulo
/// samples, columns m' from 0.
template<typename Real>
void RotationCorrelation<Real>::Tables::sum_degrees(const Harmonics& f, const Harmonics& w,
                                                    Complex* slices) const {
    std::vector<Real> sums(tile * 4 * angles), x;
    for (unsigned m = 0; m < bandwidth; ++m)
        for (unsigned first = 0; first < bandwidth; first += tile) {
            const unsigned end = std::min<unsigned>(first + tile, bandwidth);
            for (unsigned n = first; n < end; ++n)
                sum_pair(f, w, m, n, x, sums.data() + (n - first) * 4 * angles);
            for (std::size_t b = 0; b < samples; ++b) {
                Complex* positive = slices + b * slice_length() + m * row_length() + first;
                Complex* negative =
                    slices + b * slice_length() + (samples - m) % samples * row_length() + first;
                for (unsigned n = 0; n < end - first; ++n) {
                    const Real* s = sums.data() + n * 4 * angles;
                    const std::size_t back = samples - 1 - b;
                    if (m > 0)
                        negative[n] = Complex(s[2 * angles + back], s[3 * angles + back]);
                    positive[n] = Complex(s[b], s[angles + b]);
                }
            }
        }
}

template<typename Real>
RotationCorrelation<Real>::RotationCorrelation(unsigned bandwidth, unsigned samples) {
    if (bandwidth == 0 || samples % 2 != 0 || samples < 2 * bandwidth)
        throw ParameterError(
            "a correlation over rotations needs an even number of samples, at least twice its bandwidth");
    tables_ = std::make_unique<Tables>(bandwidth, samples);
}
template<typename Real>
RotationCorrelation<Real>::~RotationCorrelation() = default;
template<typename Real>
RotationCorrelation<Real>::RotationCorrelation(RotationCorrelation&&) noexcept = default;
template<typename Real>
RotationCorrelation<Real>& RotationCorrelation<Real>::operator=(RotationCorrelation&&) noexcept = default;

template<typename Real>
unsigned RotationCorrelation<Real>::samples() const {
    return static_cast<unsigned>(tables_->samples);
}

template<typename Real>
Mat3 RotationCorrelation<Real>::rotation(std::size_t a, std::size_t b, std::size_t c) const {
    const double n = static_cast<double>(tables_->samples);
    const auto about = [](double angle, const Vec3& axis) { return Eigen::AngleAxisd(angle, axis); };
    return (about(2 * pi * static_cast<double>(a) / n, Vec3::UnitZ()) *
            about(pi * (static_cast<double>(b) + 0.5) / n, Vec3::UnitY()) *
            about(2 * pi * static_cast<double>(c) / n, Vec3::UnitZ()))
        .toRotationMatrix();
}

template<typename Real>
void RotationCorrelation<Real>::operator()(const Harmonics& f, const Harmonics& w, const Visit& visit) const {
    using Complex = typename Tables::Complex;
    const Tables& t = *tables_;
    const FftwArray<Complex> slices(t.samples * t.slice_length());
    std::fill_n(slices.get(), t.samples * t.slice_length(), Complex{}); // orders that aren't there
    t.sum_degrees(f, w, slices.get());
    const FftwArray<Real> values(t.samples * t.samples);
    const FftwArray<Complex> slice(t.slice_length()); // aligned as the plan expects
    for (std::size_t b = 0; b < t.samples; ++b) {
        std::copy_n(slices.get() + b * t.slice_length(), t.slice_length(), slice.get());
        t.angles_of_slice(reinterpret_cast<typename Fftw<Real>::Complex*>(slice.get()), values.get());
        visit(b, {values.get(), t.samples * t.samples});
    }
}

double spread(const Harmonics& f, const Harmonics& w) {
    const std::vector<double> of_f = f.power(), of_w = w.power();
    double variance = 0;
    for (unsigned l = 0; l < f.bandwidth; ++l)
        variance += of_f[l] * of_w[l] / (2 * l + 1);
    return std::sqrt(variance);
}

template class RotationCorrelation<float>;
template class RotationCorrelation<double>;

} // namespace wm3d::search
