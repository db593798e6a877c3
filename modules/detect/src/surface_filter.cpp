// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/detect/surface_filter.hpp>

#include <algorithm>
#include <cmath>

#include <Eigen/IterativeLinearSolvers>
#include <Eigen/SparseCore>

#include <wm3d/core/parallel.hpp>
#include <wm3d/mesh/measure.hpp>

namespace wm3d::detect {

namespace {

using Sparse = Eigen::SparseMatrix<double>;
using Vector = Eigen::VectorXd;
using ConstMap = Eigen::Map<const Vector>;

/// Half cotangents outside this range come from slivers and would only spoil the condition of the system.
constexpr double least_weight = 1e-6, most_weight = 50;

Sparse cotangent_laplacian(const TriangleMesh& mesh) {
    std::vector<Eigen::Triplet<double>> triplets;
    triplets.reserve(mesh.triangles.size() * 12);
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
        const double twice_area = std::max(area_vector(mesh, f).norm(), 1e-300);
        for (int k = 0; k < 3; ++k) {
            const Index apex = mesh.triangles[f][k], i = mesh.triangles[f][(k + 1) % 3],
                        j = mesh.triangles[f][(k + 2) % 3];
            const Vec3 a = mesh.positions[i] - mesh.positions[apex],
                       b = mesh.positions[j] - mesh.positions[apex];
            const double weight = std::clamp(0.5 * a.dot(b) / twice_area, least_weight, most_weight);
            triplets.emplace_back(i, i, weight);
            triplets.emplace_back(j, j, weight);
            triplets.emplace_back(i, j, -weight);
            triplets.emplace_back(j, i, -weight);
        }
    }
    const auto n = static_cast<Eigen::Index>(mesh.positions.size());
    Sparse laplacian(n, n);
    laplacian.setFromTriplets(triplets.begin(), triplets.end());
    return laplacian;
}

/// Residual of the solver, relative to the right-hand side. A mark moves a vertex by a thousandth of the mean
/// radius; an error of the filter can cost a little power but never a wrong probability, which is exact for
/// any coefficients.
constexpr double tolerance = 3e-6;

using Solver =
    Eigen::ConjugateGradient<Sparse, Eigen::Lower | Eigen::Upper, Eigen::DiagonalPreconditioner<double>>;

} // namespace

struct SurfaceFilter::Operators {
    std::vector<double> mass;
    Sparse laplacian;

    Sparse system(double t) const {
        Sparse a = t * laplacian;
        for (Eigen::Index i = 0; i < a.cols(); ++i)
            a.coeffRef(i, i) += mass[static_cast<std::size_t>(i)];
        return a;
    }

    static void prepare(Solver& solver, const Sparse& a) {
        solver.setTolerance(tolerance);
        solver.setMaxIterations(1000);
        solver.compute(a);
    }
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
    // Every vertex has a diagonal entry, also the isolated ones.
    for (Eigen::Index i = 0; i < operators_->laplacian.cols(); ++i)
        operators_->laplacian.coeffRef(i, i) += 0.0;
    operators_->laplacian.makeCompressed();
}

SurfaceFilter::~SurfaceFilter() = default;
SurfaceFilter::SurfaceFilter(SurfaceFilter&&) noexcept = default;
SurfaceFilter& SurfaceFilter::operator=(SurfaceFilter&&) noexcept = default;

std::span<const double> SurfaceFilter::mass() const {
    return operators_->mass;
}

std::vector<std::vector<double>>
SurfaceFilter::low_pass(double t, const std::vector<std::vector<double>>& vectors) const {
    const Sparse a = operators_->system(t);
    const auto n = static_cast<Eigen::Index>(operators_->mass.size());
    const ConstMap mass(operators_->mass.data(), n);
    std::vector<std::vector<double>> smooth(vectors.size());
    parallel_blocks(vectors.size(), 1, [&](std::size_t begin, std::size_t end) {
        for (std::size_t k = begin; k < end; ++k) {
            const ConstMap x(vectors[k].data(), n);
            const Vector rhs = mass.cwiseProduct(x);
            // A surface is close to its own low pass, so it is the first guess.
            Solver solver;
            Operators::prepare(solver, a);
            const Vector solution = solver.solveWithGuess(rhs, x);
            smooth[k].assign(solution.data(), solution.data() + n);
        }
    });
    return smooth;
}

std::vector<double> SurfaceFilter::low_pass_transposed(double t, std::span<const double> y) const {
    const Sparse a = operators_->system(t);
    const auto n = static_cast<Eigen::Index>(operators_->mass.size());
    Solver solver;
    Operators::prepare(solver, a);
    const Vector solution = solver.solve(ConstMap(y.data(), n));
    std::vector<double> result(y.size());
    for (std::size_t i = 0; i < result.size(); ++i)
        result[i] = operators_->mass[i] * solution[static_cast<Eigen::Index>(i)];
    return result;
}

} // namespace wm3d::detect
