// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/detect/surface_filter.hpp>

#include <algorithm>
#include <array>
#include <cmath>

#include <wm3d/core/parallel.hpp>
#include <wm3d/mesh/measure.hpp>

#include "diffusion.hpp"

namespace wm3d::detect {

namespace {

/// Half cotangents outside this range come from slivers and would only spoil the condition of the system.
constexpr double least_weight = 1e-6, most_weight = 50;

constexpr int most_steps = 1000;

/// Half the cotangents of a triangle's angles, each the weight of the edge across.
std::array<double, 3> half_cotangents(const TriangleMesh& mesh, std::size_t f) {
    const double twice_area = std::max(area_vector(mesh, f).norm(), 1e-300);
    std::array<double, 3> weights;
    for (int k = 0; k < 3; ++k) {
        const Vec3& apex = mesh.positions[mesh.triangles[f][k]];
        const Vec3 a = mesh.positions[mesh.triangles[f][(k + 1) % 3]] - apex,
                   b = mesh.positions[mesh.triangles[f][(k + 2) % 3]] - apex;
        weights[k] = std::clamp(0.5 * a.dot(b) / twice_area, least_weight, most_weight);
    }
    return weights;
}

struct Entry {
    Index column;
    double value;
};

/// One entry for each triangle at each edge, row by row: `start` has #rows + 1 numbers.
std::vector<Entry> edge_entries(const TriangleMesh& mesh, std::vector<Index>& start) {
    start.assign(mesh.positions.size() + 1, 0);
    for (const Triangle& triangle : mesh.triangles)
        for (Index v : triangle)
            start[v + 1] += 2;
    for (std::size_t v = 0; v < mesh.positions.size(); ++v)
        start[v + 1] += start[v];
    std::vector<Entry> entries(start.back());
    std::vector<Index> next(start.begin(), start.end() - 1);
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
        const std::array<double, 3> weights = half_cotangents(mesh, f);
        for (int k = 0; k < 3; ++k) {
            const Index i = mesh.triangles[f][(k + 1) % 3], j = mesh.triangles[f][(k + 2) % 3];
            entries[next[i]++] = {j, -weights[k]};
            entries[next[j]++] = {i, -weights[k]};
        }
    }
    return entries;
}

SymmetricRows cotangent_laplacian(const TriangleMesh& mesh) {
    std::vector<Index> start;
    std::vector<Entry> entries = edge_entries(mesh, start);
    SymmetricRows rows;
    rows.diagonal.assign(mesh.positions.size(), 0.0);
    rows.start.assign(1, 0);
    rows.start.reserve(start.size());
    rows.column.reserve(entries.size() / 2);
    rows.value.reserve(entries.size() / 2);
    for (std::size_t v = 0; v < rows.diagonal.size(); ++v) {
        const auto begin = entries.begin() + start[v], end = entries.begin() + start[v + 1];
        std::stable_sort(begin, end, [](const Entry& a, const Entry& b) { return a.column < b.column; });
        const std::size_t first = rows.column.size();
        for (auto entry = begin; entry != end; ++entry) {
            rows.diagonal[v] -= entry->value;
            if (rows.column.size() > first && rows.column.back() == entry->column) {
                rows.value.back() += entry->value;
            } else {
                rows.column.push_back(entry->column);
                rows.value.push_back(entry->value);
            }
        }
        rows.start.push_back(static_cast<Index>(rows.column.size()));
    }
    return rows;
}

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
    SymmetricRows laplacian;

    Diffusion system(double t) const { return {mass, laplacian, t}; }
};

SurfaceFilter::SurfaceFilter(const TriangleMesh& mesh) : operators_(std::make_unique<Operators>()) {
    operators_->mass = vertex_areas(mesh);
    const double total = surface_area(mesh);
    // A vertex without area (isolated, or in degenerate triangles alone) still needs a row that can be
    // solved.
    const double least = 1e-9 * total / static_cast<double>(std::max<std::size_t>(mesh.positions.size(), 1));
    for (double& m : operators_->mass)
        m = std::max(m, least);
    operators_->laplacian = cotangent_laplacian(mesh);
}

SurfaceFilter::~SurfaceFilter() = default;
SurfaceFilter::SurfaceFilter(SurfaceFilter&&) noexcept = default;
SurfaceFilter& SurfaceFilter::operator=(SurfaceFilter&&) noexcept = default;

std::span<const double> SurfaceFilter::mass() const {
    return operators_->mass;
}

std::vector<std::vector<double>>
SurfaceFilter::low_pass(double t, const std::vector<std::vector<double>>& vectors, double tolerance) const {
    const Diffusion system = operators_->system(t);
    std::vector<std::vector<double>> smooth(vectors.size());
    // The coordinates of a surface come three at a time.
    parallel_blocks(vectors.size(), 3, [&](std::size_t begin, std::size_t end) {
        const std::span from(vectors.data() + begin, end - begin);
        const std::span to(smooth.data() + begin, end - begin);
        if (from.size() == 3)
            low_pass_together<3>(system, from, to, tolerance);
        else if (from.size() == 2)
            low_pass_together<2>(system, from, to, tolerance);
        else
            low_pass_together<1>(system, from, to, tolerance);
    });
    return smooth;
}

std::vector<double> SurfaceFilter::low_pass_transposed(double t, std::span<const double> y,
                                                       double tolerance) const {
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
