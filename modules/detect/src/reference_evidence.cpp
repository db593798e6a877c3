// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/detect/reference_evidence.hpp>

#include <algorithm>
#include <cstdint>
#include <numeric>

#include <Eigen/Core>
#include <Eigen/LU>

#include <wm3d/core/parallel.hpp>
#include <wm3d/core/split_mix.hpp>
#include <wm3d/detect/surface_filter.hpp>
#include <wm3d/mesh/measure.hpp>

namespace wm3d::detect {

namespace {

using Field = std::vector<double>;

/// Band k passes what diffusion for times[k - 1] leaves and for times[k] takes away; the last keeps all that
/// is left.
struct Bands {
    const SurfaceFilter& surface;
    const std::vector<double>& times;

    std::size_t count() const { return times.size() + 1; }

    Field low(std::size_t k, const Field& x) const { return surface.low_pass(times[k], {x}).front(); }

    Field pass(std::size_t k, const Field& x) const {
        Field y = k == 0 ? x : low(k - 1, x);
        if (k == times.size())
            return y;
        const Field smoother = low(k, x);
        for (std::size_t i = 0; i < y.size(); ++i)
            y[i] -= smoother[i];
        return y;
    }
};

/// Signs without order, the same on every run.
Field white_noise(std::size_t count) {
    Field noise(count);
    std::uint64_t state = 0;
    for (double& sign : noise)
        sign = (split_mix(state) >> 63) != 0 ? 1 : -1;
    return noise;
}

/// Variance that white noise of variance 1 has behind band k.
double noise_through(const Bands& bands, std::size_t k, std::size_t count) {
    const Field passed = bands.pass(k, white_noise(count));
    return std::inner_product(passed.begin(), passed.end(), passed.begin(), 0.0) / static_cast<double>(count);
}

double trusted_median(const Field& values, std::span<const double> trust) {
    Field trusted;
    for (std::size_t i = 0; i < values.size(); ++i)
        if (trust[i] > 0)
            trusted.push_back(values[i]);
    if (trusted.empty())
        return 0;
    const auto middle = trusted.begin() + static_cast<std::ptrdiff_t>(trusted.size() / 2);
    std::nth_element(trusted.begin(), middle, trusted.end());
    return *middle;
}

/// trust over local variance: averages of squares, divided by the averages of trust so that holes don't look
/// smooth.
Field inverse_variance(const SurfaceFilter& surface, const Field& e, std::span<const double> trust,
                       double time, double floor) {
    Field squares(e.size());
    for (std::size_t i = 0; i < e.size(); ++i)
        squares[i] = trust[i] * e[i] * e[i];
    const auto averages = surface.low_pass(time, {squares, Field(trust.begin(), trust.end())});
    Field variance(e.size());
    for (std::size_t i = 0; i < e.size(); ++i)
        variance[i] = std::max(averages[0][i], 0.0) / std::max(averages[1][i], 1e-3);
    const double typical = trusted_median(variance, trust);
    Field g(e.size(), 0.0);
    if (!(typical > 0)) // a suspect that equals its reference
        return g;
    for (std::size_t i = 0; i < e.size(); ++i)
        g[i] = trust[i] / (variance[i] + floor * typical);
    return g;
}

/// H_k^T (a g_k H_k e) = a H_k (g_k H_k e): the band passes are self-adjoint in the metric of the areas.
Field weigh_band(const Bands& bands, std::size_t k, const Field& e, std::span<const double> trust,
                 const ReferenceOptions& options) {
    const Field passed = bands.pass(k, e);
    const double time = options.variance_spread * bands.times[std::min(k, bands.times.size() - 1)];
    Field weighed = inverse_variance(bands.surface, passed, trust, time, options.variance_floor);
    // White noise has to be weighed alike in all bands, however wide they are.
    const double width = noise_through(bands, k, e.size());
    for (std::size_t i = 0; i < weighed.size(); ++i)
        weighed[i] *= width * passed[i];
    return bands.pass(k, weighed);
}

/// n . (x - low pass of x) at each time: what smoothing or coarsening of the reference itself would look
/// like.
Eigen::MatrixXd smoothing_patterns(const TriangleMesh& mesh, std::span<const Vec3> normals,
                                   const Bands& bands) {
    std::vector<Field> x(3, Field(mesh.positions.size()));
    for (std::size_t i = 0; i < mesh.positions.size(); ++i)
        for (std::size_t axis = 0; axis < 3; ++axis)
            x[axis][i] = mesh.positions[i][static_cast<Eigen::Index>(axis)];
    const auto rows = static_cast<Eigen::Index>(mesh.positions.size());
    Eigen::MatrixXd patterns(rows, static_cast<Eigen::Index>(bands.times.size()));
    parallel_blocks(bands.times.size(), 1, [&](std::size_t k, std::size_t) {
        const std::vector<Field> low = bands.surface.low_pass(bands.times[k], x);
        for (std::size_t i = 0; i < mesh.positions.size(); ++i)
            patterns(static_cast<Eigen::Index>(i), static_cast<Eigen::Index>(k)) =
                normals[i].dot(mesh.positions[i] - Vec3(low[0][i], low[1][i], low[2][i]));
    });
    return patterns;
}

/// Takes out of e what is a combination of the patterns, where it is trusted, by least squares. A few numbers
/// that the suspect and its reference determine; no key has a part in it.
Field without_patterns(Field e, std::span<const double> trust, const Eigen::MatrixXd& patterns) {
    const auto n = static_cast<Eigen::Index>(e.size());
    const Eigen::Map<const Eigen::VectorXd> weight(trust.data(), n);
    Eigen::Map<Eigen::VectorXd> difference(e.data(), n);
    const Eigen::MatrixXd normal = patterns.transpose() * weight.asDiagonal() * patterns;
    const Eigen::VectorXd share = // any of them where patterns are alike
        normal.fullPivLu().solve(patterns.transpose() * weight.cwiseProduct(difference));
    difference -= weight.cwiseProduct(patterns * share);
    return e;
}

} // namespace

ReferenceEvidence::ReferenceEvidence(const TriangleMesh& reference, std::span<const double> difference,
                                     std::span<const double> trust, const ReferenceOptions& options)
    : weighed_(reference.positions.size(), 0.0) {
    const SurfaceFilter surface(reference);
    const Bands bands{surface, options.times};
    const std::vector<Vec3> normals = vertex_normals(reference);
    const Field e = without_patterns(Field(difference.begin(), difference.end()), trust,
                                     smoothing_patterns(reference, normals, bands));
    std::vector<Field> of_band(bands.count());
    parallel_blocks(of_band.size(), 1, [&](std::size_t k, std::size_t) {
        of_band[k] = weigh_band(bands, k, e, trust, options);
    });
    const std::span<const double> area = surface.mass();
    for (std::size_t i = 0; i < weighed_.size(); ++i) {
        double sum = 0;
        for (const Field& band : of_band)
            sum += band[i];
        weighed_[i] = area[i] * normals[i].dot(reference.positions[i].normalized()) * sum;
    }
}

LinearStatistic ReferenceEvidence::statistic(const sphere::SparseRows& rows, double rmax) const {
    return {sphere::multiply_transposed(rows, weighed_), rmax};
}

} // namespace wm3d::detect
