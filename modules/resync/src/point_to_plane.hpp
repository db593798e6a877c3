// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  One term of the alignment, in a form that Ceres differentiates by itself.
#pragma once

#include <cmath>

#include <Eigen/Geometry>

#include <wm3d/mesh/types.hpp>

namespace wm3d::resync {

/// Signed distance of a moved point from a plane: n . (e^s R p + t - q).
struct PointToPlane {
    Vec3 point;  ///< p
    Vec3 foot;   ///< q, a point of the plane
    Vec3 normal; ///< n, of length 1

    /// \param rotation     unit quaternion of R: x, y, z, w
    /// \param log_scale    s
    /// \param translation  t
    template<typename T>
    bool operator()(const T* rotation, const T* log_scale, const T* translation, T* distance) const {
        using std::exp;
        using Vector = Eigen::Matrix<T, 3, 1>;
        const Eigen::Map<const Eigen::Quaternion<T>> r(rotation);
        const Eigen::Map<const Vector> t(translation);
        const Vector turned = r * point.cast<T>().eval();
        const Vector away = exp(log_scale[0]) * turned + t - foot.cast<T>();
        distance[0] = normal.cast<T>().dot(away);
        return true;
    }
};

} // namespace wm3d::resync
