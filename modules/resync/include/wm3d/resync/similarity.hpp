// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Rotation, uniform scale and translation.
#pragma once

#include <wm3d/mesh/frame.hpp>

namespace wm3d::resync {

/// p -> scale rotation p + translation. `rotation` is orthogonal; its determinant is -1 if the transform
/// mirrors.
struct Similarity {
    Mat3 rotation = Mat3::Identity();
    double scale = 1;
    Vec3 translation = Vec3::Zero();

    Vec3 operator()(const Vec3& p) const { return scale * (rotation * p) + translation; }

    Similarity inverse() const;

    /// First `first`, then this.
    Similarity operator*(const Similarity& first) const;

    bool mirrors() const;

    /// The transform of homogeneous coordinates.
    Eigen::Matrix4d matrix() const;
};

/// Where a frame of a mesh lies on the moved mesh: the canonical coordinates of p and of t(p) are the same.
Frame moved(const Frame& frame, const Similarity& t);

/// The transform to canonical coordinates, as a similarity.
Similarity to_canonical(const Frame& frame);

/// Angle between two orientations, in degrees, 0 to 180.
double angle_between(const Mat3& a, const Mat3& b);

} // namespace wm3d::resync
