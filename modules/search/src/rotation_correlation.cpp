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

/// Angles beta that are summed together: a vector of the machine. Neighbours mirror each other in pi / 2, as the
/// sums of one are those of the other for the opposite order.
constexpr std::size_t lanes = 8;
/// Orders m whose sums lie in one line of the cache.
constexpr unsigned tile = 8;

/// Adds up d[l][lane] times the eight numbers x[l]. The compiler may use wider vectors where the machine has
/// them: each sum stays in the same order.
template<typename Real>
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) &&     \
    !defined(__SANITIZE_THREAD__) // sanitizers are not ready when the loader chooses
__attribute__((target_clones("avx2", "default")))
#endif
void accumulate(const Real* d, std::size_t degrees, const Real* x, Real* sums) {
    std::array<Real, lanes> s0{}, s1{}, s2{}, s3{}, s4{}, s5{}, s6{},
        s7{}; // by themselves, so each is one vector
    for (std::size_t l = 0; l < degrees; ++l, d += lanes, x += 8)
        for (std::size_t k = 0; k < lanes; ++k) {
            s0[k] += d[k] * x[0];
            s1[k] += d[k] * x[1];
            s2[k] += d[k] * x[2];
            s3[k] += d[k] * x[3];
            s4[k] += d[k] * x[4];
            s5[k] += d[k] * x[5];
            s6[k] += d[k] * x[6];
            s7[k] += d[k] * x[7];
        }
    for (const std::array<Real, lanes>& s : {s0, s1, s2, s3, s4, s5, s6, s7})
        sums = std::copy_n(s.data(), lanes, sums);
}

} // namespace

/// d^l_mn at all angles beta for m >= n >= 0, and the plan of the last step.
template<typename Real>
struct RotationCorrelation<Real>::Tables {
    using Complex = std::complex<Real>;
    unsigned bandwidth;
    std::size_t samples, bands; ///< bands of angles: band k has 4 k, its mirror image, 4 k + 1, ...

    /// A pair of orders m >= n, and where its degrees m to bandwidth - 1 begin.
    struct Orders {
        unsigned m, n;
        std::size_t start;
    };
    std::vector<Orders> orders; ///< in the order of the work
    std::size_t rows = 0;       ///< degrees of all orders
    std::vector<Real> d;        ///< #bands by #rows by #lanes
    FftwPlan<Real> angles_of_slice;

    Tables(unsigned b, unsigned n);

    std::size_t row_length() const { return samples / 2 + 1; }
    /// Of a slice of one angle, so that every slice is aligned as the plan expects.
    std::size_t stride() const { return (samples * row_length() + 7) / 8 * 8; }
    /// The angle of a lane; `samples` or more if there is none.
    std::size_t angle(std::size_t band, std::size_t lane) const {
        const std::size_t k = band * lanes / 2 + lane / 2;
        return 2 * k >= samples ? samples : lane % 2 == 0 ? k : samples - 1 - k;
    }
    std::vector<Real> products(const Harmonics& f, const Harmonics& w) const;
    void sum_degrees(std::size_t band, const std::vector<Real>& products, Complex* slices) const;

private:
    static typename Fftw<Real>::Plan plan(std::size_t samples);
    void list_orders();
    void fill_band(std::size_t band);
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
    : bandwidth(b), samples(n), bands((samples + lanes - 1) / lanes), angles_of_slice(plan(samples)) {
    list_orders();
    d.resize(bands * rows * lanes);
    parallel_blocks(bands, 1, [&](std::size_t band, std::size_t) { fill_band(band); });
}

template<typename Real>
void RotationCorrelation<Real>::Tables::list_orders() {
    for (unsigned first = 0; first < bandwidth; first += tile)
        for (unsigned n = 0; n < std::min(first + tile, bandwidth); ++n)
            for (unsigned m = std::max(first, n); m < std::min(first + tile, bandwidth); ++m) {
                orders.push_back({m, n, rows});
                rows += bandwidth - m;
            }
}

template<typename Real>
void RotationCorrelation<Real>::Tables::fill_band(std::size_t band) {
    for (std::size_t lane = 0; lane < lanes && angle(band, lane) < samples; ++lane) {
        const double beta =
            pi * (static_cast<double>(angle(band, lane)) + 0.5) / static_cast<double>(samples);
        for (const auto& [m, n, start] : orders) {
            Real* block = d.data() + (band * rows + start) * lanes + lane;
            wigner_d(bandwidth, m, n, beta, [block, first = m](unsigned l, double value) {
                block[(l - first) * lanes] = static_cast<Real>(value);
            });
        }
    }
}

/// conj(w_lm) f_lm' for each row of the table: real and imaginary parts, conjugated, for the orders (m, n), (-m, n),
/// (n, m) and (-n, m). Those of negative order belong to d^l_-m,n(beta) = (-1)^(l - n) d^l_mn(pi - beta).
template<typename Real>
std::vector<Real> RotationCorrelation<Real>::Tables::products(const Harmonics& f, const Harmonics& w) const {
    std::vector<Real> result(8 * rows);
    for (const auto& [m, n, start] : orders)
        for (unsigned l = m; l < bandwidth; ++l) {
            const double transposed = (m - n) % 2 == 1 ? -1 : 1, mirrored = (l + n + m) % 2 == 0 ? 1 : -1;
            const std::complex<double> of_n = std::conj(f(l, n)), of_m = transposed * std::conj(f(l, m));
            const std::array<std::complex<double>, 4> x{w(l, m) * of_n, mirrored * std::conj(w(l, m)) * of_n,
                                                        w(l, n) * of_m, mirrored * std::conj(w(l, n)) * of_m};
            Real* place = result.data() + 8 * (start + l - m);
            for (std::size_t k = 0; k < x.size(); ++k) {
                place[2 * k] = static_cast<Real>(x[k].real());
                place[2 * k + 1] = static_cast<Real>(x[k].imag());
            }
        }
    return result;
}

/// The conjugate of sum over l of conj(w_lm) f_lm' d^l_mm'(beta) for the angles of a band, slice by slice: rows
/// m modulo samples, columns m' from 0.
template<typename Real>
void RotationCorrelation<Real>::Tables::sum_degrees(std::size_t band, const std::vector<Real>& products,
                                                    Complex* slices) const {
    std::fill_n(slices, lanes * stride(), Complex{}); // orders that aren't there
    std::array<Real, 8 * lanes> s{};
    for (const auto& [m, n, start] : orders) {
        accumulate(d.data() + (band * rows + start) * lanes, bandwidth - m, products.data() + 8 * start,
                   s.data());
        for (std::size_t lane = 0; lane < lanes; ++lane) {
            Complex* slice = slices + lane * stride();
            const std::size_t back = lane ^ 1; // the angle pi - beta
            if (m > 0)
                slice[(samples - m) * row_length() + n] = {s[2 * lanes + back], s[3 * lanes + back]};
            slice[m * row_length() + n] = {s[lane], s[lanes + lane]};
            if (n > 0)
                slice[(samples - n) * row_length() + m] = {s[6 * lanes + back], s[7 * lanes + back]};
            slice[n * row_length() + m] = {s[4 * lanes + lane], s[5 * lanes + lane]};
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
    const std::vector<Real> products = t.products(f, w);
    const FftwArray<Complex> slices(lanes * t.stride());
    const FftwArray<Real> values(t.samples * t.samples);
    for (std::size_t band = 0; band < t.bands; ++band) {
        t.sum_degrees(band, products, slices.get());
        for (std::size_t lane = 0; lane < lanes && t.angle(band, lane) < t.samples; ++lane) {
            Complex* slice = slices.get() + lane * t.stride();
            t.angles_of_slice(reinterpret_cast<typename Fftw<Real>::Complex*>(slice), values.get());
            visit(t.angle(band, lane), {values.get(), t.samples * t.samples});
        }
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
