// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include "conjugate_gradients.hpp"
#include "residual.hpp"

namespace wm3d::detect {

namespace {

/// D^-1/2 (I + sigma^2 J^T diag(g) J) D^-1/2 with D the diagonal of the middle, so that its own is 1: weights of the
/// hinges lie decades apart. Kept as D^-1 + A^T A.
class Whitening {
public:
    /// \param weights  g
    Whitening(const Hinges& hinges, std::vector<double> weights, double noise)
        : ends_(hinges.ends()), rows_(hinges.couplings().begin(), hinges.couplings().end()) {
        for (double& g : weights)
            g *= noise * noise;
        scale_ = hinges.squares(weights);
        for (double& s : scale_)
            s = 1 / std::sqrt(1 + s);
        for (std::size_t h = 0; h < rows_.size(); ++h) {
            const double root = std::sqrt(weights[h]);
            for (std::size_t k = 0; k < 4; ++k)
                rows_[h][k] *= root * scale_[ends_[h][k]];
        }
    }

    double diagonal(std::size_t) const { return 1; }

    std::array<double, 1> times(const Together<1>& x, Together<1>& y) const {
        double product = 0;
        for (std::size_t i = 0; i < x.size(); ++i) {
            const double scaled = scale_[i] * x[i][0];
            y[i][0] = scale_[i] * scaled;
            product += scaled * scaled;
        }
        // One hinge adds to what the one before has added to: two that lie apart don't wait for each other.
        const std::size_t half = rows_.size() / 2;
        for (std::size_t h = 0; h < half; ++h) {
            const double one = fold(h, x), other = fold(half + h, x);
            add(h, one, y);
            add(half + h, other, y);
            product += one * one + other * other;
        }
        if (rows_.size() % 2 != 0) {
            const double last = fold(2 * half, x);
            add(2 * half, last, y);
            product += last * last;
        }
        return {product};
    }

    /// (I + sigma^2 J^T diag(g) J)^-1 y, #V.
    std::vector<double> solved(std::vector<double> y) const {
        constexpr int most_steps = 500;
        Together<1> right(y.size()), x(y.size(), std::array{0.0});
        for (std::size_t i = 0; i < y.size(); ++i)
            right[i][0] = scale_[i] * y[i];
        solve(*this, right, x, whitening_tolerance, most_steps);
        for (std::size_t i = 0; i < y.size(); ++i)
            y[i] = scale_[i] * x[i][0];
        return y;
    }

private:
    /// Of A x.
    double fold(std::size_t h, const Together<1>& x) const {
        const auto& [a, b, c, d] = ends_[h];
        const std::array<double, 4>& row = rows_[h];
        return (row[0] * x[a][0] + row[1] * x[b][0]) + (row[2] * x[c][0] + row[3] * x[d][0]);
    }

    /// To A^T of the folds.
    void add(std::size_t h, double fold, Together<1>& y) const {
        for (std::size_t k = 0; k < 4; ++k)
            y[ends_[h][k]][0] += rows_[h][k] * fold;
    }

    std::span<const std::array<Index, 4>> ends_;
    std::vector<std::array<double, 4>> rows_; ///< A = sigma diag(g)^1/2 J D^-1/2
    std::vector<double> scale_;               ///< D^-1/2
};

class HingeResidual : public Residual {
public:
    HingeResidual(const Hinges& hinges, std::span<const Vec3> positions, double scale, double noise)
        : hinges_(hinges), positions_(positions), noise_(noise), square_(scale * scale),
          folds_(hinges.folds()) {
        pulled_ = pull(folds_);
    }

    std::vector<double> pulled_by(std::vector<double> moves) const override {
        std::vector<double> sum = hinges_.folds_of(moves);
        for (std::size_t h = 0; h < sum.size(); ++h)
            sum[h] += folds_[h];
        std::vector<double> y = pull(sum);
        for (std::size_t i = 0; i < y.size(); ++i)
            y[i] -= pulled_[i];
        return y;
    }

    /// J^T (g J S bumps) n, S the inverse of the whitening, which is symmetric
    std::vector<Vec3> gradient(std::vector<double> bumps) const override {
        std::vector<double> g = weights(folds_);
        std::vector<double> y = hinges_.folds_of(whitened(std::move(bumps), g));
        for (std::size_t h = 0; h < y.size(); ++h)
            y[h] *= g[h];
        return hinges_.gradient(positions_, y);
    }

private:
    /// Cauchy's: of folds whose sizes are spread over decades, the small ones tell of the mark.
    std::vector<double> weights(std::span<const double> folds) const {
        std::vector<double> g(folds.size());
        std::ranges::transform(folds, g.begin(), [this](double r) { return 1 / (r * r + square_); });
        return g;
    }

    std::vector<double> whitened(std::vector<double> y, std::vector<double> g) const {
        return noise_ > 0 ? Whitening(hinges_, std::move(g), noise_).solved(std::move(y)) : y;
    }

    /// S J^T (g r)
    std::vector<double> pull(std::span<const double> folds) const {
        std::vector<double> g = weights(folds), counted(folds.size());
        for (std::size_t h = 0; h < folds.size(); ++h)
            counted[h] = g[h] * folds[h];
        return whitened(hinges_.transposed(counted), std::move(g));
    }

    const Hinges& hinges_;
    std::span<const Vec3> positions_;
    double noise_, square_;
    std::span<const double> folds_; ///< of the hinges as they are
};

} // namespace

std::unique_ptr<Residual> hinge_residual(const Hinges& hinges, std::span<const Vec3> positions, double scale,
                                         double noise) {
    return std::make_unique<HingeResidual>(hinges, positions, scale, noise);
}

} // namespace wm3d::detect
