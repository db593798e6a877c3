// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  MSDM2, a perceptual distance between meshes: G. Lavoue, "A multiscale metric for 3D mesh visual
/// quality assessment", Computer Graphics Forum 30 (2011). Written from the description in the paper; values
/// are comparable with published ones in kind, not digit by digit.
#pragma once

#include <array>
#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>
#include <wm3d/metrics/surface_tree.hpp>

namespace wm3d::metrics {

/// Lengths are shares of the longest side of the reference's bounding box, S.
struct Msdm2Options {
    std::array<double, 3> scales{0.010, 0.015, 0.020}; ///< h_i / S, radii of the windows
    double curvature_ratio = 0.2;                      ///< curvature radius r_i / h_i
    double spread = 1.0 / 3;                           ///< deviation of the windows' Gaussian / h_i
    double weight_luminance = 1;                       ///< alpha, weight of the difference of the means
    double weight_contrast = 1;                        ///< beta, weight of the difference of the deviations
    double weight_structure = 0.5;                     ///< gamma, weight of the lack of covariance
    double stabilizer = 1;                             ///< K, added to the denominators
    double exponent = 3;                               ///< p of Minkowski's mean over the vertices
};

/// One-sided local distances, #V of `distorted`, >= 0. L and D stay below 1; T reaches 2 where C and C^ are
/// opposed.
///
/// At each scale h: C(v) = S (|k1| + |k2|) / 2 with the principal curvatures k of the tensor of D.
/// Cohen-Steiner and J.-M. Morvan (2003) in the ball of radius r; C^(v) is the reference's C, interpolated at
/// its point closest to v. Over the vertices of the window of radius h around v, weighted by a Gaussian of
/// deviation `spread` h, mu and sigma are mean and deviation of C, mu^ and sigma^ those of C^, and sigma_c
/// their covariance. Then
///     L = |mu - mu^| / (max(mu, mu^) + K)
///     D = |sigma - sigma^| / (max(sigma, sigma^) + K)
///     T = |sigma sigma^ - sigma_c| / (sigma sigma^ + K)
///     local = (alpha L + beta D + gamma T) / (alpha + beta + gamma), averaged over the scales.
std::vector<double> msdm2_field(const TriangleMesh& distorted, const SurfaceTree& reference,
                                const Msdm2Options& options = {});

/// Minkowski's mean of the local distances of exponent p, weighted by vertex areas, averaged over both
/// directions: 0 for the same surface, towards 1 where nothing agrees.
double msdm2(const SurfaceTree& a, const SurfaceTree& b, const Msdm2Options& options = {});

} // namespace wm3d::metrics
