// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The watermarking sphere: vertex j of the spherical mesh stands at the radius R + w_j, with linear
/// bumps between (section 2.2.1), and is read in the direction of a mesh vertex (section 2.2.2).
#pragma once

#include <span>
#include <vector>

#include <wm3d/sphere/icosphere.hpp>

namespace wm3d::sphere {

/// R_P of eq. (3): the distance at which the ray of `at` meets the bumped mesh. With b the barycentric
/// coordinates in the flat face and s its distance, the ray's direction is sum_j (b_j / s) v_j, so that R_P =
/// s / sum_j b_j / (R + w_j).
/// \pre  R + w_j > 0 at the three corners
double bumped_radius(const SphereLocation& at, std::span<const double> w, double radius = 1);

/// Delta = R_P - R of eq. (3).
double delta(const SphereLocation& at, std::span<const double> w, double radius = 1);

/// sum_j b_j w_j: the part of Delta that is linear in w.
double linear_delta(const SphereLocation& at, std::span<const double> w);

/// Bound of what linearization costs: 0 <= linear_delta - delta <= this, if |w_j| <= rmax < radius.
/// R_P = s H with H the weighted harmonic mean of the R + w_j and A = R + linear_delta their arithmetic mean,
/// so the difference is (A - H) + (1 - s) H. A - H is at most (sqrt(R + rmax) - sqrt(R - rmax))^2, by weights
/// 1/2 at the two ends changed for the worst ones (Kantorovich), and H at most R + rmax.
double linearization_bound(double flat_radius, double rmax, double radius = 1);

/// A spherical mesh with its bumps.
class BumpedSphere {
public:
    /// `w` holds one height per vertex.
    /// \throw ParameterError  if there are more or fewer heights than vertices, or if some R + w_j is not
    /// above 0
    BumpedSphere(Icosphere sphere, std::vector<double> w, double radius = 1);

    const Icosphere& sphere() const { return sphere_; }
    const std::vector<double>& heights() const { return w_; }
    double radius() const { return radius_; }

    /// R_P of eq. (3) in a direction.
    double radius_at(const Vec3& direction) const {
        return bumped_radius(sphere_.locate(direction), w_, radius_);
    }

    /// Delta_i = R_Pi - R of eq. (3) for every direction, in parallel.
    std::vector<double> deltas(std::span<const Vec3> directions) const;

    /// The bumped surface (figures 5 and 6 of the paper).
    TriangleMesh mesh() const;

private:
    Icosphere sphere_;
    std::vector<double> w_;
    double radius_;
};

} // namespace wm3d::sphere
