// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/detect/evidence.hpp>

#include <algorithm>
#include <cmath>

#include <wm3d/core/parallel.hpp>
#include <wm3d/mesh/measure.hpp>
#include <wm3d/mesh/umbrella.hpp>

namespace wm3d::detect {

namespace {

std::vector<std::vector<double>> coordinates(const TriangleMesh& mesh) {
    std::vector<std::vector<double>> x(3, std::vector<double>(mesh.positions.size()));
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        for (int k = 0; k < 3; ++k)
            x[k][i] = mesh.positions[i][k];
    return x;
}

/// e_i = n_i . (x_i - (low pass of x)_i)
std::vector<double> normal_residual(const TriangleMesh& mesh, std::span<const Vec3> normals,
                                    const std::vector<std::vector<double>>& smooth) {
    std::vector<double> e(mesh.positions.size());
    for (std::size_t i = 0; i < e.size(); ++i)
        e[i] = normals[i].dot(mesh.positions[i] - Vec3(smooth[0][i], smooth[1][i], smooth[2][i]));
    return e;
}

double median(std::vector<double> values) {
    const auto middle = values.begin() + static_cast<std::ptrdiff_t>(values.size() / 2);
    std::nth_element(values.begin(), middle, values.end());
    return *middle;
}

/// Weights (local variance)^-power of the residual, scaled so that their median is about 1.
std::vector<double> residual_weights(const SurfaceFilter& surface, std::span<const double> e,
                                     const Filter& filter, double variance_floor) {
    std::vector<double> g(e.size(), 1.0);
    if (filter.power == 0 || e.empty())
        return g;
    std::vector<double> squares(e.size());
    std::transform(e.begin(), e.end(), squares.begin(), [](double x) { return x * x; });
    const std::vector<double> variance = surface.low_pass(filter.variance_t, {std::move(squares)}).front();
    const double typical = median(variance);
    if (!(typical > 0)) // a polyhedron of flat sides: nothing to tell rough from smooth
        return g;
    for (std::size_t i = 0; i < g.size(); ++i)
        g[i] = std::pow(std::max(variance[i], 0.0) / typical + variance_floor, -filter.power);
    return g;
}

/// A residual as a filter counts it, and what a small addition to it counts.
struct Counted {
    std::vector<double> e, slope;
};

/// With Tukey's biweight: what lies far outside is the host's.
Counted counted(std::vector<double> e, double bound) {
    Counted result{std::move(e), {}};
    result.slope.assign(result.e.size(), 1.0);
    if (bound == 0)
        return result;
    std::vector<double> sizes(result.e.size());
    std::transform(result.e.begin(), result.e.end(), sizes.begin(), [](double x) { return std::abs(x); });
    constexpr double deviations_per_median = 1.4826; // of a normal distribution
    const double limit = bound * deviations_per_median * (sizes.empty() ? 0 : median(std::move(sizes)));
    constexpr double solvers_own = 1e-5; // of mean radii: what its tolerance leaves on a flat side
    if (!(limit > solvers_own))          // flat sides for the most part
        return result;
    for (std::size_t i = 0; i < result.e.size(); ++i) {
        const double square = std::pow(result.e[i] / limit, 2), rest = std::max(0.0, 1 - square);
        result.e[i] *= rest * rest;
        result.slope[i] = rest * (rest - 4 * square);
    }
    return result;
}

/// A surface that residuals are measured on.
struct Geometry {
    int calming = 0;
    std::vector<Vec3> positions, normals;
    SurfaceFilter surface;

    Geometry(TriangleMesh mesh, int steps)
        : calming(steps), positions(mesh.positions), normals(vertex_normals(mesh)), surface(mesh) {}
};

TriangleMesh calmed(const TriangleMesh& base, int steps) {
    constexpr double weight = 0.5;
    return {steps > 0 ? Umbrella(base).smooth(base.positions, steps, weight) : base.positions,
            base.triangles};
}

/// The low pass of the coordinates that some filters share.
struct Smooth {
    std::size_t geometry = 0;
    double t = 0;
    std::vector<std::vector<double>> coordinates;
};

} // namespace

struct Evidence::Core {
    EvidenceOptions options;
    std::vector<Geometry> geometries;         ///< the base itself first
    std::vector<std::size_t> geometry;        ///< per filter
    std::vector<std::vector<double>> weights; ///< per filter: a_i g_i
    std::vector<std::vector<double>> slopes;  ///< per filter: what an addition to e counts
    std::vector<std::vector<double>> pulled;  ///< per filter: LP^T HP^T (a g e)

    Core(const TriangleMesh& base, EvidenceOptions chosen)
        : options(std::move(chosen)), weights(options.filters.size()), slopes(options.filters.size()),
          pulled(options.filters.size()) {
        geometries.emplace_back(base, 0);
        for (const Filter& filter : options.filters)
            geometry.push_back(geometry_of(base, filter.calming));
        const std::vector<Smooth> smooth = smooth_coordinates(base);
        parallel_blocks(options.filters.size(), 1, [&](std::size_t f, std::size_t) {
            const Filter& filter = options.filters[f];
            const SurfaceFilter& surface = surface_of(f);
            const auto low = std::ranges::find_if(
                smooth, [&](const Smooth& s) { return s.geometry == geometry[f] && s.t == filter.t; });
            const std::vector<double> e = normal_residual(base, normals_of(f), low->coordinates);
            weights[f] = residual_weights(surface, e, filter, options.variance_floor);
            for (std::size_t i = 0; i < e.size(); ++i)
                weights[f][i] *= surface.mass()[i];
            Counted count = counted(e, filter.bound);
            slopes[f] = std::move(count.slope);
            pulled[f] = pull(f, count.e);
        });
    }

    const SurfaceFilter& surface_of(std::size_t f) const { return geometries[geometry[f]].surface; }
    const std::vector<Vec3>& normals_of(std::size_t f) const { return geometries[geometry[f]].normals; }

    std::size_t geometry_of(const TriangleMesh& base, int calming) {
        const auto found = std::ranges::find(geometries, calming, &Geometry::calming);
        if (found != geometries.end())
            return static_cast<std::size_t>(found - geometries.begin());
        geometries.emplace_back(calmed(base, calming), calming);
        return geometries.size() - 1;
    }

    std::vector<Smooth> smooth_coordinates(const TriangleMesh& base) const {
        std::vector<Smooth> smooth;
        for (std::size_t f = 0; f < options.filters.size(); ++f)
            if (std::ranges::none_of(smooth, [&](const Smooth& s) {
                    return s.geometry == geometry[f] && s.t == options.filters[f].t;
                }))
                smooth.push_back({geometry[f], options.filters[f].t, {}});
        const std::vector<std::vector<double>> x = coordinates(base);
        parallel_blocks(smooth.size(), 1, [&](std::size_t k, std::size_t) {
            smooth[k].coordinates = geometries[smooth[k].geometry].surface.low_pass(smooth[k].t, x);
        });
        return smooth;
    }

    /// LP^T HP^T (a g e)
    std::vector<double> pull(std::size_t f, std::span<const double> e) const {
        const Filter& filter = options.filters[f];
        std::vector<double> y(e.size());
        for (std::size_t i = 0; i < y.size(); ++i)
            y[i] = weights[f][i] * e[i];
        const std::vector<double> low = surface_of(f).low_pass_transposed(filter.t, y);
        for (std::size_t i = 0; i < y.size(); ++i)
            y[i] -= low[i];
        return filter.template_t > 0 ? surface_of(f).low_pass_transposed(filter.template_t, y) : y;
    }

    /// HP x
    std::vector<double> high_pass(std::size_t f, std::vector<double> x) const {
        const std::vector<double> low = surface_of(f).low_pass(options.filters[f].t, {x}).front();
        for (std::size_t i = 0; i < x.size(); ++i)
            x[i] -= low[i];
        return x;
    }

    /// LP x
    std::vector<double> as_template(std::size_t f, std::vector<double> x) const {
        const double t = options.filters[f].template_t;
        return t > 0 ? surface_of(f).low_pass(t, {std::move(x)}).front() : x;
    }

    /// Root of the area-weighted mean square.
    double rms(std::span<const double> x) const {
        const std::span<const double> area = geometries.front().surface.mass();
        double squares = 0, total = 0;
        for (std::size_t i = 0; i < x.size(); ++i) {
            squares += area[i] * x[i] * x[i];
            total += area[i];
        }
        return total > 0 ? std::sqrt(squares / total) : 0;
    }
};

Evidence::Evidence(const TriangleMesh& base, EvidenceOptions options)
    : Evidence(std::make_shared<const Core>(base, std::move(options)), Vec3::Zero()) {}

Evidence::Evidence(std::shared_ptr<const Core> core, const Vec3& centre) : core_(std::move(core)) {
    for (const Geometry& g : core_->geometries) {
        std::vector<double>& d_n = visibility_.emplace_back(g.positions.size());
        for (std::size_t i = 0; i < d_n.size(); ++i)
            d_n[i] = g.normals[i].dot((g.positions[i] - centre).normalized());
    }
}

Evidence Evidence::seen_from(const Vec3& centre) const {
    return {core_, centre};
}

std::size_t Evidence::filters() const {
    return core_->options.filters.size();
}

const Filter& Evidence::filter(std::size_t f) const {
    return core_->options.filters[f];
}

std::vector<double> Evidence::seen(std::size_t geometry, std::span<const double> pulled) const {
    std::vector<double> y(pulled.begin(), pulled.end());
    for (std::size_t i = 0; i < y.size(); ++i)
        y[i] *= visibility_[geometry][i];
    return y;
}

std::vector<double> Evidence::weights_at(std::size_t f) const {
    return seen(core_->geometry[f], core_->pulled[f]);
}

LinearStatistic Evidence::statistic(std::size_t f, const sphere::SparseRows& rows, double rmax) const {
    return {sphere::multiply_transposed(rows, weights_at(f)), rmax};
}

LinearStatistic Evidence::statistic(std::size_t f, const CellSamples& samples, const sphere::SparseRows& rows,
                                    double rmax) const {
    return {sphere::multiply_transposed(rows, samples.spread(seen(core_->geometry[f], core_->pulled[f]))),
            rmax};
}

std::vector<double> Evidence::normal_bumps(std::size_t geometry, const sphere::SparseRows& rows,
                                           std::span<const double> w) const {
    return seen(geometry, sphere::multiply(rows, w));
}

double Evidence::gamma(const sphere::SparseRows& rows, std::span<const double> w, double move) const {
    const double unit = core_->rms(normal_bumps(0, rows, w));
    return unit > 0 ? move / unit : 0;
}

std::vector<double> Evidence::mark_weights_at(std::size_t f, const sphere::SparseRows& rows,
                                              std::span<const double> w, double move) const {
    std::vector<double> q = normal_bumps(0, rows, w);
    const double unit = core_->rms(q);
    for (double& x : q)
        x *= unit > 0 ? move / unit : 0;
    std::vector<double> e = core_->high_pass(f, std::move(q)); // what the mark adds to the residual
    for (std::size_t i = 0; i < e.size(); ++i)
        e[i] *= core_->slopes[f][i];
    return seen(core_->geometry[f], core_->pull(f, e));
}

LinearStatistic Evidence::mark_statistic(std::size_t f, const sphere::SparseRows& rows,
                                         std::span<const double> w, double rmax, double move) const {
    return {sphere::multiply_transposed(rows, mark_weights_at(f, rows, w, move)), rmax};
}

std::vector<Vec3> Evidence::gradient(std::size_t f, const sphere::SparseRows& rows,
                                     std::span<const double> w) const {
    std::vector<double> q =
        core_->high_pass(f, core_->as_template(f, normal_bumps(core_->geometry[f], rows, w)));
    for (std::size_t i = 0; i < q.size(); ++i)
        q[i] *= core_->weights[f][i];
    std::vector<Vec3> gradient(q.size());
    parallel_blocks(3, 1, [&](std::size_t k, std::size_t) {
        const auto axis = static_cast<Eigen::Index>(k);
        std::vector<double> along(q.size());
        for (std::size_t i = 0; i < q.size(); ++i)
            along[i] = q[i] * core_->normals_of(f)[i][axis];
        const std::vector<double> low =
            core_->surface_of(f).low_pass_transposed(core_->options.filters[f].t, along);
        for (std::size_t i = 0; i < q.size(); ++i)
            gradient[i][axis] = along[i] - low[i];
    });
    return gradient;
}

double Evidence::expected_sigmas(std::size_t f, const sphere::SparseRows& rows, std::span<const double> w,
                                 double rmax, double move) const {
    const LinearStatistic own = mark_statistic(f, rows, w, rmax, move);
    const double sigma = std::hypot(statistic(f, rows, rmax).sigma(), own.sigma());
    return sigma > 0 ? own.value(w) / sigma : 0;
}

} // namespace wm3d::detect
