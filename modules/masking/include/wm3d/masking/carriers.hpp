// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The carriers of a mark at every vertex of the full mesh, each as strong as its surroundings hide.
#pragma once

#include <span>
#include <utility>
#include <vector>

#include <wm3d/detect/surface_filter.hpp>
#include <wm3d/mesh/frame.hpp>
#include <wm3d/mesh/triangle_mesh.hpp>
#include <wm3d/sphere/sparse_rows.hpp>

namespace wm3d::masking {

/// Times of diffusion are in units of mean radius squared; docs/detector.md says how they were chosen.
struct MaskOptions {
    double carrier_t = 3e-4;  ///< of the low pass that rounds the bumps off
    double residual_t = 2e-4; ///< of the low pass that the roughness is measured against
    double spread_t = 1e-3;   ///< over which roughness and what is seen are averaged
    double floor = 0.1;       ///< of the mask, where the surface is perfectly smooth; 1 is typical roughness
    /// Roughness counts as typical from this share of its root mean square on: on machined parts the median
    /// is that of a flat.
    double least_typical = 0.1;
    double most = 4; ///< no mask exceeds its area-weighted root mean square this many times
};

/// The linear map from a sequence w of the sphere's level to moves along the vertex normals,
///     m = mask .* (M + tL)^-1 M diag(d.n) B w,
/// on every vertex of the full mesh: no base triangle shows in it. The mask depends on the mesh alone.
///
/// The mask starts as the local roughness: the root of the local variance of the normal residual, relative to
/// its median. `equalize` then weighs it by what a trial mark shows.
class Carriers {
public:
    /// \param mesh   the full welded mesh; any triangles. Isolated vertices stay.
    /// \param frame  the mesh's canonical frame
    /// \throw GeometryError  if the mesh has no area
    explicit Carriers(const TriangleMesh& mesh, const Frame& frame = {}, const MaskOptions& options = {});

    /// Moves along `normals()`, #V, in mean radii per unit of w. Linear in w.
    /// \param rows  B for the vertices, of the level of w
    std::vector<double> moves(const sphere::SparseRows& rows, std::span<const double> w) const;

    /// The moves that bumps along the normals, #V, become.
    std::vector<double> carry(std::vector<double> bumps,
                              double tolerance = detect::SurfaceFilter::usual_tolerance) const {
        return masked(smooth(std::move(bumps), tolerance));
    }

    /// (M + tL)^-1 M of bumps, #V, which doesn't depend on the mask.
    /// \param tolerance  residual of the solver, relative to the right-hand side
    std::vector<double> smooth(std::vector<double> bumps,
                               double tolerance = detect::SurfaceFilter::usual_tolerance) const;

    /// What the mask leaves of smooth bumps, #V.
    std::vector<double> masked(std::vector<double> smooth) const;

    /// The bumps as they are along the normals, diag(d.n) B w, #V.
    std::vector<double> bumps(const sphere::SparseRows& rows, std::span<const double> w) const;

    /// The same from B w, #V.
    std::vector<double> bumps(std::vector<double> heights) const;

    /// Weakens the mask where a trial mark is seen more than `target` and strengthens it where less, by the
    /// square root of the ratio: half of the way to a mark that is seen alike everywhere.
    /// \param vertices  all, or an even sample of them
    /// \param seen      local visibility of the trial mark there, #vertices, >= 0
    void equalize(std::span<const Index> vertices, std::span<const double> seen, double target);

    /// No mark moves these vertices any more.
    /// \param still  #V, not 0 where a vertex is to stay
    void silence(std::span<const char> still);

    std::span<const double> mask() const { return mask_; }
    /// #V, unit, in the coordinates of the mesh; zero where isolated.
    const std::vector<Vec3>& normals() const { return normals_; }

    /// Area-weighted root mean square of moves, #V.
    double rms(std::span<const double> moves) const;

private:
    void limit();

    double diffusion(double t) const { return t * unit_ * unit_; } ///< in the mesh's unit of length

    MaskOptions options_;
    double unit_; ///< mean radius
    detect::SurfaceFilter surface_;
    std::vector<Vec3> normals_;
    std::vector<float> visibility_; ///< d.n
    std::vector<double> mask_;
};

} // namespace wm3d::masking
