// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  MSDM2, a perceptual distance between meshes: G. Lavoue, "A multiscale metric for 3D mesh visual
/// quality assessment", Computer Graphics Forum 30 (2011), as its authors' program computes it.
#pragma once

#include <array>
#include <memory>
#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>
#include <wm3d/metrics/surface_tree.hpp>

namespace wm3d::metrics {

/// The defaults are the published ones. Lengths are shares of S, the longest side of the distorted mesh's
/// box.
struct Msdm2Options {
    std::array<double, 3> scales{0.010, 0.015, 0.020}; ///< h_i / S, radii of the windows
    double curvature_ratio = 0.2;                      ///< curvature radius r_i / h_i
    double spread = 0.5;                               ///< deviation of the windows' Gaussian / h_i
    double weight_luminance = 1;                       ///< alpha, weight of the difference of the means
    double weight_contrast = 1;                        ///< beta, weight of the difference of the deviations
    double weight_structure = 0.5;                     ///< gamma, weight of the lack of covariance
    double stabilizer = 1;                             ///< K, added to the denominators
    double exponent = 3;                               ///< p of Minkowski's mean over the vertices
};

/// Local distances at some of the vertices, and what they tell of all.
struct Msdm2Sample {
    std::vector<Index> vertices; ///< with a window, ascending
    std::vector<double> local;   ///< #vertices
    double mean = 0;             ///< Minkowski's
};

/// One-sided MSDM2 of distorted meshes from one reference. What follows from the reference alone is made
/// once; for a mesh of the reference's triangles that includes the edges and where to look for closest
/// points.
///
/// At each scale h = h_i, at each vertex v of the distorted mesh: C(v) = S (|k1| + |k2|) / 2 with the
/// principal curvatures k of the tensor of D. Cohen-Steiner and J.-M. Morvan (2003) in the ball of radius r;
/// m(v), the point of the reference closest to v; C^(v), the reference's C at the corners of the triangle of
/// m(v), weighted by the areas that v spans with the sides opposite. The window of v holds v, the vertices q
/// that a walk outwards from v reaches within h, and the points where it leaves the sphere of radius h,
/// between whose ends all quantities are interpolated. With Gaussian weights of the deviation `spread` h, w
/// of |q - v| and w^ of |m(q) - m(v)|, mu and sigma are mean and deviation of C under w, mu^ and sigma^ those
/// of C^ under w^, and sigma_c = sum w^ (C - mu)(C^ - mu^) / sum w. Then
///     L = |mu - mu^| / (max(mu, mu^) + K)
///     D = |sigma - sigma^| / (max(sigma, sigma^) + K)
///     T = |sigma sigma^ - sigma_c| / (sigma sigma^ + K)
///     local = (alpha L + beta D + gamma T) / (alpha + beta + gamma), averaged over the scales,
/// and the distance is Minkowski's mean of exponent p of the local ones over the vertices of triangles.
///
/// The same bytes at any number of threads. Calls may run at the same time.
class Msdm2 {
public:
    /// The tree and its mesh must outlive the object.
    explicit Msdm2(const SurfaceTree& reference, const Msdm2Options& options = {});
    ~Msdm2();
    Msdm2(Msdm2&&) noexcept;
    Msdm2& operator=(Msdm2&&) noexcept;

    /// Makes what comparing with meshes of the reference's triangles takes, which the first of them would wait for.
    void get_ready_for_moves() const;

    /// 0 for the reference itself, towards 1 where nothing agrees.
    /// \throw GeometryError  if the mesh has no triangle
    double distance(const TriangleMesh& distorted) const;

    /// The local distances, #V of `distorted`, >= 0; 0 at vertices without a triangle. L and D stay below 1;
    /// T reaches 2 where C and C^ are opposed.
    /// \throw GeometryError if the mesh has no triangle
    std::vector<double> field(const TriangleMesh& distorted) const;

    /// Local distances at every k-th vertex of a triangle, so that at most `windows` are opened: an estimate
    /// for large meshes, where nearly all the time goes into windows of hundreds of vertices, which overlap.
    /// Of all vertices where they are not more. k is a power of two, which leaves one vertex of each cell of a
    /// mesh `along_curve`.
    /// S is that of the reference, whose curvatures are then made once for all calls: an invisible
    /// distortion changes it by a ten thousandth.
    /// \pre  windows > 0
    /// \throw GeometryError if the mesh has no triangle
    Msdm2Sample sample(const TriangleMesh& distorted, std::size_t windows) const;

    /// Local distances at some vertices, with the S of `sample`; its mean is theirs.
    /// \param vertices  ascending, none twice, each of a triangle
    /// \pre  vertices is not empty
    Msdm2Sample at(const TriangleMesh& distorted, std::vector<Index> vertices) const;

private:
    struct Prepared;
    std::unique_ptr<Prepared> prepared_;
};

/// Minkowski's mean of local distances over the vertices of triangles: `distance` from a `field`.
/// \pre  local has #V entries
double msdm2_mean(const TriangleMesh& distorted, const std::vector<double>& local, double exponent = 3);

} // namespace wm3d::metrics
