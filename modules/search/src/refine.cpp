// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/search/refine.hpp>

#include <cmath>
#include <vector>

#include <Eigen/Dense>

#include <wm3d/core/parallel.hpp>

namespace wm3d::search {

namespace {

constexpr std::size_t block = 2048; // points
constexpr Eigen::Index most_parameters = 29;
using Parameters = Eigen::Matrix<double, Eigen::Dynamic, 1, 0, most_parameters, 1>;

/// 3 of the turn, 3 of the centre, then 5 of the stretch, then 18 of the bend.
Eigen::Index parameters(Deformation deformation) {
    return deformation == Deformation::none ? 6 : deformation == Deformation::affine ? 11 : 29;
}

/// The pose a step away.
Pose stepped(const Pose& pose, const Parameters& by) {
    Pose result = pose;
    const Vec3 turn = by.head<3>();
    if (const double angle = turn.norm(); angle > 0)
        result.turn = Eigen::AngleAxisd(angle, turn / angle).toRotationMatrix() * pose.turn;
    result.centre += by.segment<3>(3);
    if (pose.deformation == Deformation::none)
        return result;
    const auto s = by.segment<5>(6);
    Mat3 stretch;
    stretch << s[0], s[2], s[3], s[2], s[1], s[4], s[3], s[4], -s[0] - s[1];
    result.stretch += stretch;
    if (pose.deformation == Deformation::bent)
        result.bend += by.segment<18>(11).reshaped(3, 6);
    return result;
}

struct Climb {
    double value = 0;
    Parameters gradient;

    explicit Climb(Eigen::Index n) : gradient(Parameters::Zero(n)) {}
    Climb& operator+=(const Climb& other) {
        value += other.value;
        gradient += other.gradient;
        return *this;
    }
};

/// Adds how q w(direction) changes with the parameters, given its gradient g by the direction.
void add_gradient(Parameters& sum, const Pose& pose, const Vec3& x, const Vec3& direction, const Vec3& g) {
    sum.head<3>() += direction.cross(g);
    const Vec3 back = pose.turn.transpose() * g; // by the undeformed point
    if (pose.deformation == Deformation::none) {
        sum.segment<3>(3) -= back;
        return;
    }
    const Vec3 y = x - pose.centre;
    const Eigen::Matrix<double, 6, 1> squares = Pose::squares(y);
    const Vec3 bent = y + pose.bend * squares, before = back + pose.stretch * back;
    sum.segment<3>(3) -= before; // the bend's own share is of second order
    sum[6] += back.x() * bent.x() - back.z() * bent.z();
    sum[7] += back.y() * bent.y() - back.z() * bent.z();
    sum[8] += back.x() * bent.y() + back.y() * bent.x();
    sum[9] += back.x() * bent.z() + back.z() * bent.x();
    sum[10] += back.y() * bent.z() + back.z() * bent.y();
    if (pose.deformation == Deformation::bent)
        for (Eigen::Index k = 0; k < 6; ++k)
            sum.segment<3>(11 + 3 * k) += squares[k] * before;
}

/// Value and gradient at a pose. `faces` of the sphere, #points, are where the points were seen last: a step moves few
/// of them to another.
Climb climb(std::span<const Vec3> x, std::span<const double> q, const KeyFunction& key, const Pose& pose,
            std::span<Index> faces) {
    const Eigen::Index n = parameters(pose.deformation);
    return parallel_sum(x.size(), block, Climb(n), [&](std::size_t begin, std::size_t end) {
        Climb sum(n);
        for (std::size_t i = begin; i < end; ++i) {
            const Vec3 direction = pose.direction(x[i]);
            const KeyFunction::Value w = key(direction, faces[i]);
            sum.value += q[i] * w.value;
            add_gradient(sum.gradient, pose, x[i], direction, q[i] * w.gradient);
        }
        return sum;
    });
}

} // namespace

double correlation(std::span<const Vec3> x, std::span<const double> q, const KeyFunction& key,
                   const Pose& pose) {
    return parallel_sum_of(x.size(), block,
                           [&](std::size_t i) { return q[i] * key(pose.direction(x[i])).value; });
}

Refined refine(std::span<const Vec3> x, std::span<const double> q, const KeyFunction& key, const Pose& start,
               const RefineOptions& options) {
    const Eigen::Index n = parameters(start.deformation);
    Refined best{start};
    std::vector<Index> faces(x.size(), no_index);
    Climb at = climb(x, q, key, start, faces);
    best.value = at.value;
    Eigen::MatrixXd inverse; // of the Hessian's negative
    for (; best.iterations < options.iterations && at.gradient.norm() > 0; ++best.iterations) {
        if (inverse.size() == 0)
            inverse = Eigen::MatrixXd::Identity(n, n) * (options.first_step / at.gradient.norm());
        Parameters step = inverse * at.gradient;
        if (const double longest = step.cwiseAbs().maxCoeff(); longest > 4 * options.first_step)
            step *= 4 * options.first_step / longest;
        // Backtracking: the function has kinks at every edge of the sphere.
        Climb next(n);
        Pose pose;
        double length = 1;
        for (; length > 0.02; length /= 2.5) {
            pose = stepped(best.pose, length * step);
            next = climb(x, q, key, pose, faces);
            if (next.value > at.value + 1e-3 * length * step.dot(at.gradient))
                break;
        }
        if (length <= 0.02) {
            if (inverse.isDiagonal()) { // not even along the gradient
                best.arrived = true;
                break;
            }
            inverse.resize(0, 0); // forget the curvature
            continue;
        }
        const Eigen::VectorXd s = length * step, y = at.gradient - next.gradient;
        const double gain = next.value - at.value;
        best.pose = pose;
        best.value = next.value;
        at = next;
        if (gain < options.least_gain * std::abs(best.value)) {
            best.arrived = true;
            break;
        }
        if (const double sy = s.dot(y); sy > 1e-12 * s.norm() * y.norm()) {
            const Eigen::MatrixXd left = Eigen::MatrixXd::Identity(n, n) - s * y.transpose() / sy;
            inverse = left * inverse * left.transpose() + s * s.transpose() / sy;
        }
    }
    return best;
}

} // namespace wm3d::search
