// SPDX-License-Identifier: GPL-3.0-or-later
#include "solver.hpp"

#include <ceres/ceres.h>

namespace wm3d::resync {

namespace {

using TermCost = ceres::AutoDiffCostFunction<PointToPlane, 1, 4, 1, 3>;

ceres::Solver::Options solver_options() {
    ceres::Solver::Options options;
    options.linear_solver_type = ceres::DENSE_NORMAL_CHOLESKY;
    options.max_num_iterations = 6; // the planes change before more would pay
    options.num_threads = 1;        // one order of sums
    options.function_tolerance = 1e-12;
    options.logging_type = ceres::SILENT;
    return options;
}

} // namespace

Similarity solve(std::span<const PointToPlane> terms, const Similarity& start, double loss_width) {
    Eigen::Quaterniond rotation(start.rotation);
    double log_scale = std::log(start.scale);
    Vec3 translation = start.translation;

    ceres::TukeyLoss loss(loss_width);
    ceres::Problem::Options ownership;
    ownership.loss_function_ownership = ceres::DO_NOT_TAKE_OWNERSHIP;
    ceres::Problem problem(ownership);
    for (const PointToPlane& term : terms)
        problem.AddResidualBlock(new TermCost(new PointToPlane(term)), &loss, rotation.coeffs().data(),
                                 &log_scale, translation.data());
    problem.SetManifold(rotation.coeffs().data(), new ceres::EigenQuaternionManifold);

    ceres::Solver::Summary summary;
    ceres::Solve(solver_options(), &problem, &summary);
    if (!summary.IsSolutionUsable())
        return start;
    return {rotation.normalized().toRotationMatrix(), std::exp(log_scale), translation};
}

} // namespace wm3d::resync
