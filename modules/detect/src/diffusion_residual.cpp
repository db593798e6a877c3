// SPDX-License-Identifier: GPL-3.0-or-later
#include <algorithm>
#include <cmath>

#include <wm3d/core/parallel.hpp>

#include "residual.hpp"

namespace wm3d::detect {

namespace {

/// Of solutions that weigh a residual, or carry it back: an error of this part costs its square of the score.
constexpr double weighing_tolerance = 3e-3;

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// e_i = n_i . (x_i - (low pass of x)_i)
std::vector<double> normal_residual(const TriangleMesh& mesh, std::span<const Vec3> normals,
                                    const std::vector<std::vector<double>>& smooth) {
    std::vector<double> e(mesh.positions.size());
    for (std::size_t i = 0; i < e.size(); ++i)
        e[i] = normals[i].dot(mesh.positions[i] - Vec3(smooth[0][i], smooth[1][i], smooth[2][i]));
    return e;
}

/// Weights (local variance)^-power of the residual, scaled so that their median is about 1.
std::vector<double> residual_weights(const SurfaceFilter& surface, std::span<const double> e,
                                     const Filter& filter, double variance_floor) {
    std::vector<double> g(e.size(), 1.0);
    if (filter.power == 0 || e.empty())
        return g;
    std::vector<double> squares(e.size());
    std::transform(e.begin(), e.end(), squares.begin(), [](double x) { return x * x; });
    const std::vector<double> variance =
        surface.low_pass(filter.variance_t, {std::move(squares)}, weighing_tolerance).front();
    const double typical = median(variance);
    if (!(typical > 0)) // a polyhedron of flat sides: nothing to tell rough from smooth
        return g;
    for (std::size_t i = 0; i < g.size(); ++i)
        g[i] = std::pow(std::max(variance[i], 0.0) / typical + variance_floor, -filter.power);
    return g;
}

/// Beyond it a residual is the host's; 0 where none is bounded.
double limit_of(std::span<const double> e, double bound) {
    if (bound == 0 || e.empty())
        return 0;
    std::vector<double> sizes(e.size());
    std::ranges::transform(e, sizes.begin(), [](double x) { return std::abs(x); });
    constexpr double deviations_per_median = 1.4826; // of a normal distribution
    constexpr double solvers_own = 1e-5; // of mean radii: what its tolerance leaves on a flat side
    const double limit = bound * deviations_per_median * median(std::move(sizes));
    return limit > solvers_own ? limit : 0; // else flat sides for the most part
}

class DiffusionResidual : public Residual {
public:
    DiffusionResidual(const TriangleMesh& base, const Geometry& geometry, const Filter& filter,
                      double variance_floor, const std::vector<std::vector<double>>& smooth)
        : geometry_(geometry), filter_(filter), own_(normal_residual(base, geometry.normals, smooth)),
          limit_(limit_of(own_, filter.bound)),
          weights_(residual_weights(*geometry.surface, own_, filter, variance_floor)) {
        for (std::size_t i = 0; i < weights_.size(); ++i)
            weights_[i] *= geometry.surface->mass()[i];
        std::vector<double> e = own_;
        for (double& x : e)
            x = counted(x);
        pulled_ = pull(std::move(e));
    }

    std::vector<double> pulled_by(std::vector<double> moves) const override {
        std::vector<double> e = high_pass(std::move(moves));
        for (std::size_t i = 0; i < e.size(); ++i)
            e[i] = counted(own_[i] + e[i]) - counted(own_[i]);
        return pull(std::move(e));
    }

    /// HP^T (a g HP LP bumps) n
    std::vector<Vec3> gradient(std::vector<double> bumps) const override {
        std::vector<double> q = high_pass(as_template(std::move(bumps)));
        for (std::size_t i = 0; i < q.size(); ++i)
            q[i] *= weights_[i];
        std::vector<Vec3> gradient(q.size());
        parallel_blocks(3, 1, [&](std::size_t k, std::size_t) {
            const auto axis = static_cast<Eigen::Index>(k);
            std::vector<double> along(q.size());
            for (std::size_t i = 0; i < q.size(); ++i)
                along[i] = q[i] * geometry_.normals[i][axis];
            along = high_pass_transposed(std::move(along));
            for (std::size_t i = 0; i < q.size(); ++i)
                gradient[i][axis] = along[i];
        });
        return gradient;
    }

private:
    /// Tukey's biweight: what lies far outside is the host's.
    double counted(double e) const {
        if (limit_ == 0)
            return e;
        const double rest = std::max(0.0, 1 - std::pow(e / limit_, 2));
        return e * rest * rest;
    }

    /// LP^T HP^T (a g e)
    std::vector<double> pull(std::vector<double> e) const {
        for (std::size_t i = 0; i < e.size(); ++i)
            e[i] *= weights_[i];
        std::vector<double> y = high_pass_transposed(std::move(e), weighing_tolerance);
        return filter_.template_t > 0
                   ? geometry_.surface->low_pass_transposed(filter_.template_t, y, weighing_tolerance)
                   : y;
    }

    std::vector<double> high_pass(std::vector<double> x) const {
        const std::vector<double> low = geometry_.surface->low_pass(filter_.t, {x}).front();
        for (std::size_t i = 0; i < x.size(); ++i)
            x[i] -= low[i];
        return x;
    }

    std::vector<double> high_pass_transposed(std::vector<double> y,
                                             double tolerance = SurfaceFilter::usual_tolerance) const {
        const std::vector<double> low = geometry_.surface->low_pass_transposed(filter_.t, y, tolerance);
        for (std::size_t i = 0; i < y.size(); ++i)
            y[i] -= low[i];
        return y;
    }

    /// LP x
    std::vector<double> as_template(std::vector<double> x) const {
        const double t = filter_.template_t;
        return t > 0 ? geometry_.surface->low_pass(t, {std::move(x)}).front() : x;
    }

    const Geometry& geometry_;
    Filter filter_;
    std::vector<double> own_;
    double limit_;
    std::vector<double> weights_; ///< a_i g_i
};

} // namespace

std::unique_ptr<Residual> diffusion_residual(const TriangleMesh& base, const Geometry& geometry,
                                             const Filter& filter, double variance_floor,
                                             const std::vector<std::vector<double>>& smooth) {
    return std::make_unique<DiffusionResidual>(base, geometry, filter, variance_floor, smooth);
}

} // namespace wm3d::detect
