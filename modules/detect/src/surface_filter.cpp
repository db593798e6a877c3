// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/detect/surface_filter.hpp>

#include <algorithm>
#include <array>
#include <numeric>
#include <optional>
#include <utility>

#include <wm3d/core/parallel.hpp>
#include <wm3d/mesh/measure.hpp>

#include "diffusion.hpp"
#include "multilevel_diffusion.hpp"
#include "symmetric_rows.hpp"

namespace wm3d::detect {

namespace {

constexpr int most_steps = 1000;

/// Rows from which on a hierarchy saves more steps than each of its own costs.
constexpr std::size_t many_rows = 200'000;

/// (M + tL)^-1 M x for K vectors.
template<std::size_t K>
void low_pass_together(const Diffusion& system, std::span<const std::vector<double>> vectors,
                       std::span<std::vector<double>> smooth, double tolerance) {
    const std::size_t n = system.mass.size();
    Together<K> y(n), x(n);
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t k = 0; k < K; ++k) {
            x[i][k] = vectors[k][i]; // a surface is close to its own low pass, so it is the first guess
            y[i][k] = system.mass[i] * x[i][k];
        }
    solve(system, y, x, tolerance, most_steps);
    for (std::size_t k = 0; k < K; ++k) {
        smooth[k].resize(n);
        for (std::size_t i = 0; i < n; ++i)
            smooth[k][i] = x[i][k];
    }
}

} // namespace

struct SurfaceFilter::Operators {
    std::vector<double> mass;
    SymmetricRows laplacian;                  ///< of a surface of usual density
    std::optional<MultilevelDiffusion> dense; ///< or of a dense one

    Diffusion system(double t) const { return {mass, laplacian, t}; }
};

SurfaceFilter::SurfaceFilter(const TriangleMesh& mesh) : SurfaceFilter(mesh, vertex_areas(mesh)) {}

SurfaceFilter::SurfaceFilter(const TriangleMesh& mesh, std::vector<double> areas)
    : operators_(std::make_unique<Operators>()) {
    operators_->mass = std::move(areas);
    const double total = std::accumulate(operators_->mass.begin(), operators_->mass.end(), 0.0);
    // A vertex without area (isolated, or in degenerate triangles alone) still needs a row that can be
    // solved.
    const double least = 1e-9 * total / static_cast<double>(std::max<std::size_t>(mesh.positions.size(), 1));
    for (double& m : operators_->mass)
        m = std::max(m, least);
    if (mesh.positions.size() < many_rows)
        operators_->laplacian = cotangent_laplacian<double>(mesh, entries_at_once);
    else
        operators_->dense.emplace(mesh, operators_->mass);
}

SurfaceFilter::~SurfaceFilter() = default;
SurfaceFilter::SurfaceFilter(SurfaceFilter&&) noexcept = default;
SurfaceFilter& SurfaceFilter::operator=(SurfaceFilter&&) noexcept = default;

std::span<const double> SurfaceFilter::mass() const {
    return operators_->mass;
}

std::vector<std::vector<double>> SurfaceFilter::low_pass(double t, std::vector<std::vector<double>> vectors,
                                                         double tolerance) const {
    if (operators_->dense) {
        operators_->dense->diffuse(t, vectors, tolerance, most_steps);
        return vectors;
    }
    const Diffusion system = operators_->system(t);
    std::vector<std::vector<double>> smooth(vectors.size());
    // The coordinates of a surface share passes over the matrix; of other vectors each has a thread.
    const std::size_t together = vectors.size() % 3 == 0 ? 3 : 1;
    parallel_blocks(vectors.size(), together, [&](std::size_t begin, std::size_t) {
        const std::span from = std::span<const std::vector<double>>(vectors).subspan(begin, together);
        const std::span to = std::span(smooth).subspan(begin, together);
        if (together == 3)
            low_pass_together<3>(system, from, to, tolerance);
        else
            low_pass_together<1>(system, from, to, tolerance);
    });
    return smooth;
}

std::vector<double> SurfaceFilter::low_pass_transposed(double t, std::span<const double> y,
                                                       double tolerance) const {
    if (operators_->dense) {
        std::vector<double> x(y.begin(), y.end());
        for (std::size_t i = 0; i < x.size(); ++i)
            x[i] /= operators_->mass[i];
        operators_->dense->diffuse(t, std::span(&x, 1), tolerance, most_steps);
        for (std::size_t i = 0; i < x.size(); ++i)
            x[i] *= operators_->mass[i];
        return x;
    }
    Together<1> right(y.size()), x(y.size(), std::array{0.0});
    for (std::size_t i = 0; i < y.size(); ++i)
        right[i][0] = y[i];
    solve(operators_->system(t), right, x, tolerance, most_steps);
    std::vector<double> result(y.size());
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = operators_->mass[i] * x[i][0];
    return result;
}

} // namespace wm3d::detect
