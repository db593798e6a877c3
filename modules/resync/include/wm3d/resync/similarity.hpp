// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Rotation, uniform scale and translation.
#pragma once

#include <Eigen/Geometry>

#include <wm3d/mesh/frame.hpp>

namespace wm3d::resync {

/// p -> scale rotation p + translation. `rotation` is orthogonal; its determinant is -1 if the transform
/// mirrors.
struct Similarity {
    Mat3 rotation = Mat3::Identity();
    double scale = 1;
    Vec3 translation = Vec3::Zero();

    Vec3 operator()(const Vec3& p) const { return scale * (rotation * p) + translation; }

    Similarity inverse() const {
        return {rotation.transpose(), 1 / scale, -(rotation.transpose() * translation) / scale};
    }

    /// First `first`, then this.
    Similarity operator*(const Similarity& first) const {
        return {rotation * first.rotation, scale * first.scale, (*this)(first.translation)};
    }

    bool mirrors() const { return rotation.determinant() < 0; }

    /// The transform of homogeneous coordinates.
    Eigen::Matrix4d matrix() const {
        Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
        m.topLeftCorner<3, 3>() = scale * rotation;
        m.topRightCorner<3, 1>() = translation;
        return m;
    }
};

/// Where a frame of a mesh lies on the moved mesh: the canonical coordinates of p and of t(p) are the same.
inline Frame moved(const Frame& frame, const Similarity& t) {
    return {t(frame.centroid), frame.axes * t.rotation.transpose(), t.scale * frame.scale};
}

/// The transform to canonical coordinates, as a similarity.
inline Similarity to_canonical(const Frame& frame) {
    return {frame.axes, 1 / frame.scale, -(frame.axes * frame.centroid) / frame.scale};
}

/// Angle between two orientations, in degrees, 0 to 180.
inline double angle_between(const Mat3& a, const Mat3& b) {
    constexpr double degree = 57.29577951308232;
    return Eigen::AngleAxisd(Eigen::Quaterniond(Mat3(a * b.transpose()))).angle() * degree;
}

} // namespace wm3d::resync
