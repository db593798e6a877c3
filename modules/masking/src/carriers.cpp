// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/masking/carriers.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <wm3d/core/parallel.hpp>
#include <wm3d/mesh/measure.hpp>

namespace wm3d::masking {

namespace {

/// Of averages that weigh the mask.
constexpr double spread_tolerance = 3e-3;

/// Of what roughness is measured against; a few thousandths of the roughness are wrong then.
constexpr double residual_tolerance = 1e-5;

/// Median over the vertices that have a normal, and so triangles.
double typical_value(std::span<const double> x, std::span<const Vec3> normals) {
    std::vector<double> used;
    for (std::size_t i = 0; i < x.size(); ++i)
        if (normals[i] != Vec3::Zero())
            used.push_back(x[i]);
    if (used.empty())
        return 0;
    const auto middle = used.begin() + static_cast<std::ptrdiff_t>(used.size() / 2);
    std::nth_element(used.begin(), middle, used.end());
    return *middle;
}

constexpr std::size_t vertex_block = 16384;

template<typename Do>
void for_each_vertex(std::size_t count, Do&& act) {
    parallel_blocks(count, vertex_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            act(i);
    });
}

double area_rms(std::span<const double> x, std::span<const double> area) {
    const double total = parallel_sum_of(x.size(), vertex_block, [&](std::size_t i) { return area[i]; });
    const double squares =
        parallel_sum_of(x.size(), vertex_block, [&](std::size_t i) { return area[i] * x[i] * x[i]; });
    return total > 0 ? std::sqrt(squares / total) : 0;
}

/// n . (x - low pass of x), #V; x from the centroid, since what a solution leaves is a part of x.
std::vector<double> normal_residual(const TriangleMesh& mesh, const Vec3& centroid,
                                    std::span<const Vec3> normals, const detect::SurfaceFilter& surface,
                                    double t) {
    const std::size_t count = mesh.positions.size();
    std::vector<std::vector<double>> x(3, std::vector<double>(count));
    for_each_vertex(count, [&](std::size_t i) {
        const Vec3 p = mesh.positions[i] - centroid;
        for (std::size_t k = 0; k < 3; ++k)
            x[k][i] = p[static_cast<Eigen::Index>(k)];
    });
    x = surface.low_pass(t, std::move(x), residual_tolerance);
    for_each_vertex(count, [&](std::size_t i) {
        const Vec3 smooth(x[0][i], x[1][i], x[2][i]);
        x[0][i] = normals[i].dot(mesh.positions[i] - centroid - smooth);
    });
    return std::move(x[0]);
}

/// The low pass of one vector, which is not copied.
std::vector<double> low_pass_of(const detect::SurfaceFilter& surface, double t, std::vector<double> x,
                                double tolerance) {
    std::vector<std::vector<double>> vectors;
    vectors.push_back(std::move(x)); // a list in braces would copy it
    return std::move(surface.low_pass(t, std::move(vectors), tolerance).front());
}

/// Root of the local mean of the squares.
std::vector<double> local_rms(std::vector<double> x, const detect::SurfaceFilter& surface, double t) {
    for_each_vertex(x.size(), [&](std::size_t i) { x[i] *= x[i]; });
    x = low_pass_of(surface, t, std::move(x), spread_tolerance);
    for_each_vertex(x.size(), [&](std::size_t i) { x[i] = std::sqrt(std::max(x[i], 0.0)); });
    return x;
}

} // namespace

Carriers::Carriers(const TriangleMesh& mesh, const Frame& frame, const MaskOptions& options)
    : options_(options), unit_(frame.scale), surface_(mesh), normals_(vertex_normals(mesh)),
      visibility_(mesh.positions.size()),
      mask_(
          local_rms(normal_residual(mesh, frame.centroid, normals_, surface_, diffusion(options.residual_t)),
                    surface_, diffusion(options.spread_t))) {
    for_each_vertex(visibility_.size(), [&](std::size_t i) {
        visibility_[i] =
            static_cast<float>(normals_[i].dot((mesh.positions[i] - frame.centroid).normalized()));
    });
    const double typical =
        std::max(typical_value(mask_, normals_), options_.least_typical * area_rms(mask_, surface_.mass()));
    for_each_vertex(mask_.size(), [&](std::size_t i) {
        mask_[i] = normals_[i] != Vec3::Zero() ? (typical > 0 ? mask_[i] / typical : 0) + options_.floor : 0;
    });
    limit();
}

void Carriers::limit() {
    const double most = options_.most * area_rms(mask_, surface_.mass());
    for_each_vertex(mask_.size(), [&](std::size_t i) { mask_[i] = std::min(mask_[i], most); });
}

std::vector<double> Carriers::bumps(std::vector<double> heights) const {
    for_each_vertex(heights.size(),
                    [&](std::size_t i) { heights[i] *= static_cast<double>(visibility_[i]); });
    return heights;
}

std::vector<double> Carriers::bumps(const sphere::SparseRows& rows, std::span<const double> w) const {
    return bumps(sphere::multiply(rows, w));
}

std::vector<double> Carriers::smooth(std::vector<double> bumps, double tolerance) const {
    return low_pass_of(surface_, diffusion(options_.carrier_t), std::move(bumps), tolerance);
}

std::vector<double> Carriers::masked(std::vector<double> smooth) const {
    for_each_vertex(smooth.size(), [&](std::size_t i) { smooth[i] *= mask_[i]; });
    return smooth;
}

std::vector<double> Carriers::moves(const sphere::SparseRows& rows, std::span<const double> w) const {
    return carry(bumps(rows, w));
}

void Carriers::equalize(std::span<const Index> vertices, std::span<const double> seen, double target) {
    constexpr double least_seen = 0.02; // of the target: what is seen less is not told apart
    constexpr double weakest = 0.04, strongest = 5;
    constexpr double nowhere = 1e-4; // share of sampled vertices around, as good as none
    std::vector<std::vector<double>> spread(
        2, std::vector<double>(mask_.size(), 0.0)); // what is seen, and whether it is known
    for (std::size_t i = 0; i < vertices.size(); ++i) {
        spread[0][vertices[i]] = seen[i];
        spread[1][vertices[i]] = 1;
    }
    spread = surface_.low_pass(diffusion(options_.spread_t), std::move(spread), spread_tolerance);
    for_each_vertex(mask_.size(), [&](std::size_t i) {
        const double around = spread[1][i] > nowhere ? spread[0][i] / spread[1][i] : target;
        mask_[i] *= std::clamp(std::sqrt(target / std::max(around, least_seen * target)), weakest, strongest);
    });
    limit();
}

void Carriers::silence(std::span<const char> still) {
    for (std::size_t i = 0; i < mask_.size(); ++i)
        if (still[i])
            mask_[i] = 0;
    limit();
}

double Carriers::rms(std::span<const double> moves) const {
    return area_rms(moves, surface_.mass());
}

} // namespace wm3d::masking
