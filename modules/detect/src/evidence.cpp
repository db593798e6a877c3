// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/detect/evidence.hpp>

#include <algorithm>
#include <cmath>
#include <optional>

#include <fmt/format.h>

#include <wm3d/core/parallel.hpp>
#include <wm3d/mesh/measure.hpp>
#include <wm3d/mesh/umbrella.hpp>

#include "residual.hpp"

namespace wm3d::detect {

namespace {

std::vector<std::vector<double>> coordinates(const TriangleMesh& mesh) {
    std::vector<std::vector<double>> x(3, std::vector<double>(mesh.positions.size()));
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        for (int k = 0; k < 3; ++k)
            x[k][i] = mesh.positions[i][k];
    return x;
}

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

/// c with its sizes brought nearer to each other.
std::vector<double> evened(std::vector<double> c) {
    for (double& x : c)
        x = std::copysign(std::sqrt(std::abs(x)), x);
    return c;
}

} // namespace

Geometry::Geometry(const TriangleMesh& mesh, int steps, bool diffuses)
    : calming(steps), positions(mesh.positions), normals(vertex_normals(mesh)), area(vertex_areas(mesh)) {
    if (diffuses)
        surface.emplace(mesh, area);
}

std::string describe(const Filter& filter) {
    if (filter.hinges == 0)
        return fmt::format("filter t = {:g}, power {:g}", filter.t, filter.power);
    return filter.noise > 0 ? fmt::format("hinges of {:g}, noise {:g}", filter.hinges, filter.noise)
                            : fmt::format("hinges of {:g}", filter.hinges);
}

struct Evidence::Core {
    EvidenceOptions options;
    std::vector<Geometry> geometries;                 ///< the base itself first
    std::vector<std::size_t> geometry;                ///< per filter
    std::optional<Hinges> hinges;                     ///< where a filter looks at them
    std::vector<std::unique_ptr<Residual>> residuals; ///< per filter

    Core(const TriangleMesh& base, EvidenceOptions chosen)
        : options(std::move(chosen)), residuals(options.filters.size()) {
        geometries.reserve(1 + options.filters.size()); // the first stays where it is while others are added
        geometries.emplace_back(base, 0, diffuses_on(0));
        parallel_invoke(
            [&] {
                for (const Filter& filter : options.filters)
                    geometry.push_back(geometry_of(base, filter.calming));
            },
            [&] {
                if (std::ranges::any_of(options.filters, [](const Filter& f) { return f.hinges > 0; }))
                    hinges.emplace(base, geometries.front().normals);
            });
        const std::vector<Smooth> smooth = smooth_coordinates(base);
        parallel_blocks(options.filters.size(), 1,
                        [&](std::size_t f, std::size_t) { residuals[f] = residual(base, f, smooth); });
    }

    std::size_t geometry_of(const TriangleMesh& base, int calming) {
        const auto found = std::ranges::find(geometries, calming, &Geometry::calming);
        if (found != geometries.end())
            return static_cast<std::size_t>(found - geometries.begin());
        geometries.emplace_back(calmed(base, calming), calming, diffuses_on(calming));
        return geometries.size() - 1;
    }

    bool diffuses_on(int calming) const {
        return std::ranges::any_of(options.filters,
                                   [&](const Filter& f) { return f.hinges == 0 && f.calming == calming; });
    }

    std::vector<Smooth> smooth_coordinates(const TriangleMesh& base) const {
        std::vector<Smooth> smooth;
        for (std::size_t f = 0; f < options.filters.size(); ++f)
            if (options.filters[f].hinges == 0 && std::ranges::none_of(smooth, [&](const Smooth& s) {
                    return s.geometry == geometry[f] && s.t == options.filters[f].t;
                }))
                smooth.push_back({geometry[f], options.filters[f].t, {}});
        const std::vector<std::vector<double>> x = coordinates(base);
        parallel_blocks(smooth.size(), 1, [&](std::size_t k, std::size_t) {
            smooth[k].coordinates = geometries[smooth[k].geometry].surface->low_pass(smooth[k].t, x);
        });
        return smooth;
    }

    std::unique_ptr<Residual> residual(const TriangleMesh& base, std::size_t f,
                                       std::span<const Smooth> smooth) const {
        const Filter& filter = options.filters[f];
        if (filter.hinges > 0)
            return hinge_residual(*hinges, geometries.front().positions, filter.hinges, filter.noise);
        const auto low = std::ranges::find_if(
            smooth, [&](const Smooth& s) { return s.geometry == geometry[f] && s.t == filter.t; });
        return diffusion_residual(base, geometries[geometry[f]], filter, options.variance_floor,
                                  low->coordinates);
    }

    /// Root of the area-weighted mean square.
    double rms(std::span<const double> x) const {
        const std::span<const double> area = geometries.front().area;
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
    return seen(core_->geometry[f], core_->residuals[f]->pulled());
}

LinearStatistic Evidence::statistic(std::size_t f, const sphere::SparseRows& rows, double rmax) const {
    return counted(f, sphere::multiply_transposed(rows, weights_at(f)), rmax);
}

LinearStatistic Evidence::statistic(std::size_t f, const CellSamples& samples, const sphere::SparseRows& rows,
                                    double rmax) const {
    return counted(f, sphere::multiply_transposed(rows, samples.spread(weights_at(f))), rmax);
}

LinearStatistic Evidence::counted(std::size_t f, std::vector<double> coefficients, double rmax) const {
    return {filter(f).evened ? evened(std::move(coefficients)) : std::move(coefficients), rmax};
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
    return seen(core_->geometry[f], core_->residuals[f]->pulled_by(std::move(q)));
}

std::vector<Vec3> Evidence::gradient(std::size_t f, const sphere::SparseRows& rows,
                                     std::span<const double> w) const {
    return core_->residuals[f]->gradient(normal_bumps(core_->geometry[f], rows, w));
}

double Evidence::expected_sigmas(std::size_t f, const sphere::SparseRows& rows, std::span<const double> w,
                                 double rmax, double move) const {
    std::vector<double> host = weights_at(f), marked = mark_weights_at(f, rows, w, move);
    for (std::size_t i = 0; i < host.size(); ++i)
        marked[i] += host[i];
    const LinearStatistic before = counted(f, sphere::multiply_transposed(rows, host), rmax),
                          after = counted(f, sphere::multiply_transposed(rows, marked), rmax);
    return after.sigma() > 0 ? (after.value(w) - before.value(w)) / after.sigma() : 0;
}

} // namespace wm3d::detect
