// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Quadric error of planes (M. Garland, P. Heckbert, SIGGRAPH 1997), each quadric about its own
/// vertex: numbers near zero keep their digits, and most constants and linear terms start as exact zeros.
#pragma once

#include <wm3d/mesh/types.hpp>

namespace wm3d::simplify {

/// E(d) = d^T A d + 2 b^T d, the weighted sum of squared distances of the point `vertex + d` from a set of
/// planes, without its constant E(0): that one is stored with the position, where neighbours read it.
struct Quadric {
    double xx = 0, xy = 0, xz = 0, yy = 0, yz = 0, zz = 0; ///< A
    double x = 0, y = 0, z = 0;                            ///< b

    /// Adds the plane through the vertex with normal m; the weight is the square of m's length.
    void add_plane(const Vec3& m) {
        xx += m[0] * m[0], xy += m[0] * m[1], xz += m[0] * m[2];
        yy += m[1] * m[1], yz += m[1] * m[2], zz += m[2] * m[2];
    }

    /// Adds `weight` times the squared distance from the vertex.
    void add_point(double weight) { xx += weight, yy += weight, zz += weight; }

    /// A d
    Vec3 apply(const Vec3& d) const {
        return {xx * d[0] + xy * d[1] + xz * d[2], xy * d[0] + yy * d[1] + yz * d[2],
                xz * d[0] + yz * d[1] + zz * d[2]};
    }

    double evaluate(const Vec3& d) const { return d.dot(apply(d) + 2 * Vec3{x, y, z}); }

    /// The weights of all planes together.
    double trace() const { return xx + yy + zz; }

    /// Adds `other`, whose vertex lies at -d from this one's.
    void merge(const Quadric& other, const Vec3& d) {
        const Vec3 moved = other.apply(d) + Vec3{other.x, other.y, other.z};
        xx += other.xx, xy += other.xy, xz += other.xz, yy += other.yy, yz += other.yz, zz += other.zz;
        x += moved[0], y += moved[1], z += moved[2];
    }
};

} // namespace wm3d::simplify
