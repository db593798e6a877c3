// SPDX-License-Identifier: GPL-3.0-or-later
// This work is based on R. Lugannani and S. Rice, "Saddle point approximation for the distribution of the sum
// of independent random variables" (Adv. Appl. Prob. 12, 1980), and on the Bromwich integral it starts from.
#include <wm3d/detect/tail.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <complex>
#include <limits>
#include <numbers>
#include <vector>

#include <Eigen/Core>
#include <wm3d/detect/verdict.hpp>

namespace wm3d::detect {

namespace {

constexpr double ln10 = std::numbers::ln10;
constexpr double minus_infinity = -std::numeric_limits<double>::infinity();

/// And the cumulants there.
struct Saddlepoint {
    double s;
    Cumulants k;
};

/// Root s > 0 of K'(s) = t for 0 < t < maximum. K' is concave for s > 0, so Newton's steps from 0 never
/// overshoot.
/// \param last_step  over s: a step that is no longer is not taken
Saddlepoint saddlepoint(const LinearStatistic& statistic, double t, double last_step = 1e-13) {
    double s = t / (statistic.sigma() * statistic.sigma());
    Cumulants k = cumulants(statistic, s);
    for (int step = 0; step < 200; ++step) {
        const double next = s + (t - k.k1) / k.k2;
        if (!(next > s * (1 + last_step)) || !std::isfinite(next))
            break;
        s = next;
        k = cumulants(statistic, s);
    }
    return {s, k};
}

/// log of the standard normal's upper tail.
double log_normal_tail(double z) {
    if (z < 25)
        return std::log(std::erfc(z / std::numbers::sqrt2) / 2);
    const double u = 1 / (z * z);
    return -z * z / 2 - std::log(z * std::sqrt(2 * std::numbers::pi)) +
           std::log1p(u * (-1 + u * (3 - 15 * u)));
}

/// log of Lugannani and Rice's approximation, t > 0.
double saddlepoint_log_tail(const LinearStatistic& statistic, double t) {
    const auto [s, k] = saddlepoint(statistic, t);
    const double exponent = std::max(s * t - k.k0, 0.0);
    const double r = std::sqrt(2 * exponent); // signed root
    const double u = s * std::sqrt(k.k2);
    if (r < 1e-3) // next to the mean the two terms cancel
        return log_normal_tail(t / statistic.sigma());
    // Q(r) + phi(r) (1/u - 1/r), with phi(r) taken out so that nothing underflows
    const double log_phi = -exponent - 0.5 * std::log(2 * std::numbers::pi);
    const double mills = std::exp(log_normal_tail(r) - log_phi);
    return log_phi + std::log(mills + 1 / u - 1 / r);
}

/// Ratio exp(K(s + iy) - K(s)) at y = h, 2h, 3h and so on. It is a product: of the factors sinh(x_j)/x_j for
/// uniform numbers, cosh(x_j) for signs, with x_j = a_j (s + iy).
class ShiftedCharacteristic {
public:
    static constexpr std::size_t run = 8;

    ShiftedCharacteristic(const LinearStatistic& statistic, double s, double h)
        : s_(s), h_(h), uniform_(statistic.law() == Law::uniform) {
        constexpr double negligible = 1e-9; // of a s: the factor is 1 to double precision
        std::vector<double> scales;
        for (double c : statistic.coefficients()) {
            const double a = statistic.rmax() * std::abs(c);
            if (a * s >= negligible || a >= 1e-12 * statistic.sigma())
                scales.push_back(a);
        }
        while (scales.size() % lanes != 0)
            scales.push_back(1e-3 * negligible / s);
        for (std::size_t j = 0; j < scales.size(); j += lanes)
            packs_.push_back(pack(scales.data() + j));
    }

    /// The ratio at the next `run` multiples of h.
    std::array<std::complex<double>, run> next() {
        std::array<std::complex<double>, run> inverse;
        for (std::complex<double>& z : inverse)
            z = uniform_ ? 1.0 / std::complex<double>(1, ++multiple_ * h_ / s_) : std::complex<double>(1);
        std::array<Lanes, run> re, im;
        re.fill(Lanes::Ones());
        im.fill(Lanes::Zero());
        for (Pack& p : packs_)
            for (std::size_t k = 0; k < run; ++k) {
                // u = a s, v = a y: sinh(u + iv) / sinh u * u / (u + iv), or cosh(u + iv) / cosh u
                const Lanes x = p.cos * p.turn_cos - p.sin * p.turn_sin;
                p.sin = p.sin * p.turn_cos + p.cos * p.turn_sin;
                p.cos = x;
                const Lanes w = p.sin * p.slope;
                const Lanes fx = x * inverse[k].real() - w * inverse[k].imag();
                const Lanes fw = x * inverse[k].imag() + w * inverse[k].real();
                const Lanes product = re[k] * fx - im[k] * fw;
                im[k] = re[k] * fw + im[k] * fx;
                re[k] = product;
            }
        std::array<std::complex<double>, run> ratio;
        for (std::size_t k = 0; k < run; ++k) {
            ratio[k] = 1;
            for (Eigen::Index lane = 0; lane < lanes; ++lane)
                ratio[k] *= std::complex<double>(re[k][lane], im[k][lane]);
        }
        return ratio;
    }

private:
    static constexpr Eigen::Index lanes = 4;
    using Lanes = Eigen::Array<double, lanes, 1>;

    /// Factors whose angles a y are turned on by a h from one multiple to the next.
    struct Pack {
        Lanes slope, turn_cos, turn_sin;
        Lanes cos = Lanes::Ones(), sin = Lanes::Zero();
    };

    Pack pack(const double* scales) const {
        Pack p;
        for (Eigen::Index lane = 0; lane < lanes; ++lane) {
            const double a = scales[lane];
            p.slope[lane] = uniform_ ? 1 / std::tanh(a * s_) : std::tanh(a * s_);
            p.turn_cos[lane] = std::cos(a * h_);
            p.turn_sin[lane] = std::sin(a * h_);
        }
        return p;
    }

    double s_, h_;
    bool uniform_;
    int multiple_ = 0;
    std::vector<Pack> packs_;
};

/// The line of integration, which may pass anywhere right of 0 and costs least near the saddlepoint: near the mean it
/// passes right of that, away from the pole.
Saddlepoint line_of(const LinearStatistic& statistic, double t) {
    constexpr double near = 1e-3;
    const double least = 1 / statistic.sigma();
    if (t > 0)
        if (const Saddlepoint found = saddlepoint(statistic, t, near); found.s >= least)
            return found;
    return {least, cumulants(statistic, least)};
}

struct Integral {
    double value = 0;
    double relative_error = std::numeric_limits<double>::infinity();
};

/// Integral over y > 0 of Re[exp(K(s + iy) - K(s) - iyt) / (s + iy)] with step h, compared with step 2h.
Integral bromwich(const LinearStatistic& statistic, double s, double t, double h) {
    constexpr int most = 400, quiet_run = 4;
    ShiftedCharacteristic ratio(statistic, s, h);
    double fine = 0.5 / s, coarse = fine;
    int quiet = 0, k = 0;
    while (k < most && quiet < quiet_run)
        for (const std::complex<double>& shifted : ratio.next()) {
            const double y = ++k * h;
            const std::complex<double> term = shifted * std::polar(1.0, -y * t) / std::complex<double>(s, y);
            fine += term.real();
            if (k % 2 == 0)
                coarse += term.real();
            quiet = std::abs(term) < 1e-17 * std::abs(fine) ? quiet + 1 : 0;
            if (quiet == quiet_run)
                break;
        }
    Integral integral;
    integral.value = fine * h;
    if (quiet == quiet_run && fine > 0)
        integral.relative_error = std::abs(fine - 2 * coarse) / fine;
    return integral;
}

} // namespace

Tail exact_tail(const LinearStatistic& statistic, double t) {
    if (!(statistic.sigma() > 0))
        return {t > 0 ? minus_infinity : 0.0, 0, false};
    if (t < 0) { // T is symmetric
        const Tail other = exact_tail(statistic, -t);
        const double p = std::pow(10.0, other.log10_p);
        return {std::log1p(-p) / ln10, other.relative_error * p / (1 - p), false};
    }
    if (t > statistic.maximum())
        return {minus_infinity, 0, false};
    const auto [s, k] = line_of(statistic, t);
    // The step resolves the integrand's width at the saddlepoint and the distance to the pole.
    const double h = std::min(0.4 / std::sqrt(k.k2), s / 8);
    const Integral integral = bromwich(statistic, s, t, h);
    if (!(integral.relative_error < 1e-6))
        return {chernoff_log10_bound(statistic, t), integral.relative_error, true};
    const double log_p = k.k0 - s * t + std::log(integral.value / std::numbers::pi);
    return {std::min(log_p / ln10, 0.0), integral.relative_error, false};
}

double saddlepoint_log10_tail(const LinearStatistic& statistic, double t) {
    if (!(statistic.sigma() > 0))
        return t > 0 ? minus_infinity : 0.0;
    if (t >= statistic.maximum())
        return minus_infinity;
    if (t > 0)
        return saddlepoint_log_tail(statistic, t) / ln10;
    if (t == 0)
        return std::log10(0.5);
    if (-t >= statistic.maximum())
        return 0;
    return std::log1p(-std::exp(saddlepoint_log_tail(statistic, -t))) / ln10;
}

double chernoff_log10_bound(const LinearStatistic& statistic, double t) {
    if (!(t > 0))
        return 0;
    if (!(statistic.sigma() > 0) || t > statistic.maximum())
        return minus_infinity;
    const auto [s, k] = saddlepoint(statistic, t);
    return (k.k0 - s * t) / ln10;
}

double tail_quantile(const LinearStatistic& statistic, double log10_pf) {
    // In units of normal quantiles the tail is almost a straight line, so steps of slope 1/sigma contract.
    const double target = normal_sigmas(log10_pf), sigma = statistic.sigma();
    double t = std::min(sigma * target, 0.999 * statistic.maximum());
    double low = target > 0 ? 0 : -statistic.maximum(), high = statistic.maximum();
    for (int step = 0; step < 100; ++step) {
        const double log10_p = saddlepoint_log10_tail(statistic, t);
        if (std::abs(log10_p - log10_pf) < 1e-9 || high - low < 1e-12 * high)
            break;
        (log10_p > log10_pf ? low : high) = t;
        // A normal quantile exists inside (0, 1) only; a step that leaves what is known is halved instead.
        const bool ordinary = log10_p > -300 && log10_p < -1e-9;
        const double next = ordinary ? t + sigma * (target - normal_sigmas(log10_p)) : high;
        t = next > low && next < high ? next : 0.5 * (low + high);
    }
    return t;
}

} // namespace wm3d::detect
