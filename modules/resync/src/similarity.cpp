// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/resync/similarity.hpp>

#include <Eigen/Geometry>

namespace wm3d::resync {

Similarity Similarity::inverse() const {
    return {rotation.transpose(), 1 / scale, -(rotation.transpose() * translation) / scale};
}

Similarity Similarity::operator*(const Similarity& first) const {
    return {rotation * first.rotation, scale * first.scale, (*this)(first.translation)};
}

bool Similarity::mirrors() const {
    return rotation.determinant() < 0;
}

Eigen::Matrix4d Similarity::matrix() const {
    Eigen::Matrix4d m = Eigen::Matrix4d::Identity();
    m.topLeftCorner<3, 3>() = scale * rotation;
    m.topRightCorner<3, 1>() = translation;
    return m;
}

Frame moved(const Frame& frame, const Similarity& t) {
    return {t(frame.centroid), frame.axes * t.rotation.transpose(), t.scale * frame.scale};
}

Similarity to_canonical(const Frame& frame) {
    return {frame.axes, 1 / frame.scale, -(frame.axes * frame.centroid) / frame.scale};
}

double angle_between(const Mat3& a, const Mat3& b) {
    constexpr double degree = 57.29577951308232;
    return Eigen::AngleAxisd(Eigen::Quaterniond(Mat3(a * b.transpose()))).angle() * degree;
}

} // namespace wm3d::resync
