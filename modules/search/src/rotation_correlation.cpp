// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/search/rotation_correlation.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstring>
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

/// Coefficients of one order, degree after degree.
template<typename Real>
struct Column {
    const Real *re, *im;
};

/// So many numbers at once: one vector of a machine that has such wide ones. GCC and Clang both know this type.
template<typename Real>
struct VectorOf {
    typedef Real Type __attribute__((vector_size(lanes * sizeof(Real))));
};

/// Adds up, for the orders (m, n) and (-m, n), d[l][lane] times real and imaginary parts of the conjugates of
/// conj(w_lm) f_ln and of its counterpart of order -m, which belongs to d^l_-m,n(beta) = (-1)^(l - n) d^l_mn(pi - beta).
/// `sign` is (-1)^(l + m + n) of the first degree; columns are read to a multiple of lanes. Each sum stays in the same
/// order on every machine.
template<typename Real>
#if defined(__GNUC__) && !defined(__clang__) && defined(__x86_64__) && !defined(__SANITIZE_ADDRESS__) &&     \
    !defined(__SANITIZE_THREAD__) // sanitizers are not ready when the loader chooses
__attribute__((target_clones("avx2", "default")))
#endif
void accumulate(const Real* d, std::size_t degrees, const Column<Real>& w, const Column<Real>& f, Real sign,
                Real* sums) {
    using Vector = typename VectorOf<Real>::Type;
    const auto load = [](Vector& v, const Real* from) { std::memcpy(&v, from, sizeof(v)); };
    Vector s0{}, s1{}, s2{}, s3{};
    static_assert(lanes == 8);
    const Vector alternating = Vector{1, -1, 1, -1, 1, -1, 1, -1} * sign;
    alignas(Vector) std::array<Real, 4 * lanes> x; // of some degrees
    for (std::size_t l = 0; l < degrees; l += lanes) {
        Vector w_re, w_im, f_re, f_im;
        load(w_re, w.re + l);
        load(w_im, w.im + l);
        load(f_re, f.re + l);
        load(f_im, f.im + l);
        const std::array<Vector, 4> of_degrees{w_re * f_re + w_im * f_im, w_im * f_re - w_re * f_im,
                                               alternating * (w_re * f_re - w_im * f_im),
                                               -alternating * (w_im * f_re + w_re * f_im)};
        std::memcpy(x.data(), of_degrees.data(), sizeof(x));
        const std::size_t end = std::min(lanes, degrees - l);
        for (std::size_t i = 0; i < end; ++i, d += lanes) {
            Vector of_angles;
            load(of_angles, d);
            s0 += of_angles * x[i];
            s1 += of_angles * x[lanes + i];
            s2 += of_angles * x[2 * lanes + i];
            s3 += of_angles * x[3 * lanes + i];
        }
    }
    for (const Vector& s : {s0, s1, s2, s3}) {
        std::memcpy(sums, &s, sizeof(s));
        sums += lanes;
    }
}

/// The coefficients of one function, order by order, with room to read beyond the last degree.
template<typename Real>
class Coefficients {
public:
    Coefficients(const Harmonics& f, unsigned bandwidth)
        : stride_(bandwidth + lanes), re_(bandwidth * stride_), im_(re_.size()) {
        for (unsigned m = 0; m < bandwidth; ++m)
            for (unsigned l = m; l < bandwidth; ++l) {
                re_[m * stride_ + l] = static_cast<Real>(f(l, m).real());
                im_[m * stride_ + l] = static_cast<Real>(f(l, m).imag());
            }
    }
    Column<Real> column(unsigned l, unsigned m) const {
        return {&re_[m * stride_ + l], &im_[m * stride_ + l]};
    }

private:
    std::size_t stride_;
    std::vector<Real> re_, im_;
};

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
    FftwPlan<Real> angles_of_slices;

    Tables(unsigned b, unsigned n);

    /// Of two slices, those of an angle and of its mirror image, so that each pair is aligned as the plan expects.
    std::size_t stride() const { return (samples * samples + 7) / 8 * 8; }
    /// The angle of a lane; `samples` or more if there is none.
    std::size_t angle(std::size_t band, std::size_t lane) const {
        const std::size_t k = band * lanes / 2 + lane / 2;
        return 2 * k >= samples ? samples : lane % 2 == 0 ? k : samples - 1 - k;
    }
    void sum_degrees(std::size_t band, std::span<const Coefficients<Real>> f, const Coefficients<Real>& w,
                     Complex* slices) const;

private:
    void place(const Orders& of, const Real* sums, Complex* slices) const;
    static typename Fftw<Real>::Plan plan(std::size_t samples);
    void list_orders();
    void fill_band(std::size_t band);
};

template<typename Real>
typename Fftw<Real>::Plan RotationCorrelation<Real>::Tables::plan(std::size_t samples) {
    const std::lock_guard lock(planner());
    const FftwArray<typename Fftw<Real>::Complex> in(samples * samples), out(samples * samples);
    const int n = static_cast<int>(samples);
    return Fftw<Real>::complex_to_complex(n, n, in.get(), out.get());
}

template<typename Real>
RotationCorrelation<Real>::Tables::Tables(unsigned b, unsigned n)
    : bandwidth(b), samples(n), bands((samples + lanes - 1) / lanes), angles_of_slices(plan(samples)) {
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

/// With X the conjugate of sum over l of conj(w_lm) f_lm' d^l_mm'(beta) at an angle and Y that at its mirror image, the
/// two pairs of orders and their negatives of X + i Y: rows m modulo samples, columns m' modulo samples. What belongs to
/// (-m, -m') is conj(X) + i conj(Y), since both become real.
template<typename Real>
void RotationCorrelation<Real>::Tables::place(const Orders& of, const Real* sums, Complex* slices) const {
    const auto at = [n = samples](std::size_t row, std::size_t column) { return row * n + column; };
    const auto minus = [n = samples](std::size_t m) { return m == 0 ? 0 : n - m; };
    const std::size_t m = of.m, n = of.n;
    const Real transposed = (m - n) % 2 == 1 ? -1 : 1; // d^l_nm = (-1)^(m - n) d^l_mn
    for (std::size_t pair = 0; pair < lanes / 2; ++pair, slices += stride()) {
        const auto put = [&](std::size_t k, std::size_t lane, Real factor, std::size_t here,
                             std::size_t opposite) {
            const Real* re = sums + 2 * k * lanes;
            const Real* im = re + lanes;
            const std::size_t mirror = lane ^ 1;
            slices[here] = factor * Complex(re[lane] - im[mirror], im[lane] + re[mirror]);
            slices[opposite] = factor * Complex(re[lane] + im[mirror], re[mirror] - im[lane]);
        };
        const std::size_t lane = 2 * pair, back = lane + 1; // the angle pi - beta
        put(1, back, 1, at(minus(m), n), at(m, minus(n)));
        put(0, lane, 1, at(m, n), at(minus(m), minus(n)));
        put(3, back, transposed, at(minus(n), m), at(n, minus(m)));
        put(2, lane, transposed, at(n, m), at(minus(n), minus(m)));
    }
}

/// The pairs of slices of a band of angles, for each of the functions f.
template<typename Real>
void RotationCorrelation<Real>::Tables::sum_degrees(std::size_t band, std::span<const Coefficients<Real>> f,
                                                    const Coefficients<Real>& w, Complex* slices) const {
    std::array<Real, 8 * lanes> sums{};
    for (const Orders& of : orders)
        for (std::size_t k = 0; k < f.size(); ++k) {
            const Real* there = d.data() + (band * rows + of.start) * lanes;
            const std::size_t degrees = bandwidth - of.m;
            const Real sign = of.n % 2 == 0 ? 1 : -1;
            accumulate(there, degrees, w.column(of.m, of.m), f[k].column(of.m, of.n), sign, sums.data());
            accumulate(there, degrees, w.column(of.m, of.n), f[k].column(of.m, of.m), sign,
                       sums.data() + 4 * lanes);
            place(of, sums.data(), slices + k * (lanes / 2) * stride());
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
void RotationCorrelation<Real>::operator()(std::span<const Harmonics> f, const Harmonics& w,
                                           const Visit& visit) const {
    using Complex = typename Tables::Complex;
    using OfFftw = typename Fftw<Real>::Complex;
    const Tables& t = *tables_;
    const Coefficients<Real> of_w(w, t.bandwidth);
    std::vector<Coefficients<Real>> of_f;
    for (const Harmonics& one : f)
        of_f.emplace_back(one, t.bandwidth);
    const std::size_t pairs = f.size() * (lanes / 2), size = t.samples * t.samples;
    const FftwArray<Complex> slices(pairs * t.stride()), values(size);
    std::fill_n(slices.get(), pairs * t.stride(), Complex{}); // orders that aren't there
    for (std::size_t band = 0; band < t.bands; ++band) {
        t.sum_degrees(band, of_f, of_w, slices.get());
        for (std::size_t pair = 0; pair < pairs; ++pair) {
            const std::size_t b = t.angle(band, 2 * (pair % (lanes / 2)));
            if (b >= t.samples)
                continue;
            t.angles_of_slices(reinterpret_cast<OfFftw*>(slices.get() + pair * t.stride()),
                               reinterpret_cast<OfFftw*>(values.get()));
            visit(pair / (lanes / 2), b, {values.get(), size});
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
