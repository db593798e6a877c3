// SPDX-License-Identifier: GPL-3.0-or-later
#include "residual.hpp"

namespace wm3d::detect {

namespace {

class HingeResidual : public Residual {
public:
    HingeResidual(const Hinges& hinges, double scale)
        : hinges_(hinges), folds_(hinges.folds()), square_(scale * scale) {
        pulled_ = hinges_.transposed(counted(folds_));
    }

    std::vector<double> pulled_by(std::vector<double> moves) const override {
        std::vector<double> sum = hinges_.folds_of(moves);
        for (std::size_t h = 0; h < sum.size(); ++h)
            sum[h] += folds_[h];
        std::vector<double> y = hinges_.transposed(counted(sum));
        for (std::size_t i = 0; i < y.size(); ++i)
            y[i] -= pulled_[i];
        return y;
    }

    std::vector<Vec3> gradient(std::vector<double> bumps) const override {
        std::vector<double> y = hinges_.folds_of(bumps);
        for (std::size_t h = 0; h < y.size(); ++h)
            y[h] *= weight(folds_[h]);
        return hinges_.gradient(y);
    }

private:
    /// Cauchy's: of folds whose sizes are spread over decades, the small ones tell of the mark.
    double weight(double fold) const { return 1 / (fold * fold + square_); }

    std::vector<double> counted(std::vector<double> folds) const {
        for (double& r : folds)
            r *= weight(r);
        return folds;
    }

    const Hinges& hinges_;
    std::vector<double> folds_;
    double square_;
};

} // namespace

std::unique_ptr<Residual> hinge_residual(const Hinges& hinges, double scale) {
    return std::make_unique<HingeResidual>(hinges, scale);
}

} // namespace wm3d::detect
