// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/search/pose.hpp>

#include <algorithm>
#include <cmath>

namespace wm3d::search {

namespace {

/// Multiples of `step` up to `most` either way.
double places(double most, double step) {
    return 2 * std::floor(most / step + 1e-9) + 1;
}

double rounded(double value, double most, double step) {
    const double limit = std::floor(most / step + 1e-9);
    return step * std::clamp(std::round(value / step), -limit, limit);
}

/// The quaternion over its largest component, the other three rounded.
Mat3 rounded_turn(const Mat3& turn, double step) {
    const double sign = turn.determinant() < 0 ? -1 : 1;
    Eigen::Vector4d q = Eigen::Quaterniond(Mat3(sign * turn)).coeffs();
    Eigen::Index largest = 0;
    q.cwiseAbs().maxCoeff(&largest);
    q /= q[largest];
    for (Eigen::Index k = 0; k < 4; ++k)
        if (k != largest)
            q[k] = rounded(q[k], 1, step);
    return sign * Eigen::Quaterniond(q).normalized().toRotationMatrix();
}

} // namespace

std::string_view name(Deformation deformation) {
    switch (deformation) {
    case Deformation::none:
        return "none";
    case Deformation::affine:
        return "affine";
    default:
        return "bent";
    }
}

Pose PoseLattice::nearest(const Pose& pose) const {
    Pose result = pose;
    for (double& c : result.centre)
        c = rounded(c, reach, step);
    result.turn = rounded_turn(pose.turn, step);
    if (pose.deformation == Deformation::none) {
        result.stretch.setZero();
    } else {
        // Five free entries: three off the diagonal, two on it.
        for (Eigen::Index r = 0; r < 3; ++r)
            for (Eigen::Index c = r; c < 3; ++c)
                result.stretch(r, c) = result.stretch(c, r) =
                    rounded((pose.stretch(r, c) + pose.stretch(c, r)) / 2, most_stretch, step);
        result.stretch(2, 2) = -result.stretch(0, 0) - result.stretch(1, 1);
    }
    if (pose.deformation == Deformation::bent)
        for (double& b : result.bend.reshaped())
            b = rounded(b, most_bend, step);
    else
        result.bend.setZero();
    return result;
}

double PoseLattice::log10_size(Deformation deformation) const {
    double size = 3 * std::log10(places(reach, step)) + std::log10(4 * 2) + 3 * std::log10(places(1, step));
    if (deformation != Deformation::none)
        size += 5 * std::log10(places(most_stretch, step));
    if (deformation == Deformation::bent)
        size += 18 * std::log10(places(most_bend, step));
    return size;
}

} // namespace wm3d::search
