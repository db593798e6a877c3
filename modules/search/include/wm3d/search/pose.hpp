// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Where the key's sphere may lie on a suspect, and the fixed lattice of such places that a verdict
/// pays for.
#pragma once

#include <array>
#include <cstddef>
#include <string_view>

#include <wm3d/mesh/types.hpp>

namespace wm3d::search {

/// What may have been done to the shape besides moving, turning, scaling and cutting it.
enum class Deformation {
    none,
    affine, ///< scaled differently along three axes, or sheared
    bent,   ///< and bent: a map of second degree
};

std::string_view name(Deformation deformation);

/// The point x of the suspect looks in the direction turn * (1 + stretch) (y + bend(y)) of the key's sphere,
/// with y = x - centre in the suspect's units. Scale doesn't matter to a direction.
struct Pose {
    Vec3 centre = Vec3::Zero();
    Mat3 turn = Mat3::Identity(); ///< orthogonal; its determinant is -1 for a mirror image
    Mat3 stretch = Mat3::Zero();  ///< symmetric, without trace
    Eigen::Matrix<double, 3, 6> bend = Eigen::Matrix<double, 3, 6>::Zero(); ///< times `squares(y)`
    Deformation deformation = Deformation::none;

    /// The six products of second degree: xx, yy, zz, yz, zx, xy.
    static Eigen::Matrix<double, 6, 1> squares(const Vec3& y) {
        return {y.x() * y.x(), y.y() * y.y(), y.z() * y.z(), y.y() * y.z(), y.z() * y.x(), y.x() * y.y()};
    }

    /// y + bend(y), stretched: the undeformed suspect around the centre, not yet turned.
    Vec3 undeformed(const Vec3& x) const {
        const Vec3 y = x - centre;
        return deformation == Deformation::none ? y
                                                : y + bend * squares(y) + stretch * (y + bend * squares(y));
    }

    Vec3 direction(const Vec3& x) const { return turn * undeformed(x); }

    bool mirrors() const { return turn.determinant() < 0; }
};

/// A finite set of poses that is fixed by the suspect alone. Whatever leads to a pose, be it a refinement
/// that follows the key: if the statistic is taken at a member of the set, the probability that any member
/// scores as well for a random key is at most the number of members times that of one (Bonferroni).
struct PoseLattice {
    double reach = 2;    ///< of the centre along each axis, in the suspect's units
    double step = 0.004; ///< of the centre, of a quaternion over its largest component, and of deformations
    double most_stretch = 0.1; ///< of each entry of a stretch
    double most_bend = 0.1;    ///< of each coefficient of a bend

    /// The member nearest to a pose, as it is rounded. Stretch and bend are cut off at their limits.
    Pose nearest(const Pose& pose) const;

    /// log10 of the number of members with this deformation, mirror images included.
    double log10_size(Deformation deformation) const;
};

} // namespace wm3d::search
