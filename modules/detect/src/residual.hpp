// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  What one filter of the bank leaves of a suspect: the two kinds of residuals.
#pragma once

#include <memory>
#include <optional>
#include <span>
#include <vector>

#include <wm3d/detect/evidence.hpp>

#include "hinges.hpp"

namespace wm3d::detect {

/// A surface that residuals are measured on: the suspect's own, or a calmed copy.
struct Geometry {
    int calming = 0;
    std::vector<Vec3> positions, normals;
    std::vector<double> area;             ///< of the vertices
    std::optional<SurfaceFilter> surface; ///< where a diffusion looks at it

    Geometry(const TriangleMesh& mesh, int steps, bool diffuses);
};

/// A residual of the suspect that is linear in its vertices' moves until it is counted, and the way back from it to the
/// vertices.
class Residual {
public:
    virtual ~Residual() = default;

    /// What the suspect's own residual gives each vertex, #V: T is the sum of these times the normal moves of
    /// the mark.
    std::span<const double> pulled() const { return pulled_; }

    /// What `moves` along the vertex normals, #V, add to `pulled` if they are made on this very mesh.
    virtual std::vector<double> pulled_by(std::vector<double> moves) const = 0;

    /// How T grows with the vertices' moves, #V, where the mark moves them along their normals by `bumps`; normals,
    /// areas and weights held.
    virtual std::vector<Vec3> gradient(std::vector<double> bumps) const = 0;

protected:
    std::vector<double> pulled_;
};

/// e = n . HP x at the vertices. `smooth`: the low pass of the coordinates of `base`, 3 by #V. `geometry` has to outlive
/// it.
std::unique_ptr<Residual> diffusion_residual(const TriangleMesh& base, const Geometry& geometry,
                                             const Filter& filter, double variance_floor,
                                             const std::vector<std::vector<double>>& smooth);

/// Of the solution that whitens folds, relative. The noise it is meant for is never quite that of a suspect: steps beyond
/// this cost scores under noise, and what fewer would leave out costs those of rounded copies (docs/detector.md).
inline constexpr double whitening_tolerance = 3e-2;

/// Folds at the edges, by Cauchy's weights of this scale, whitened against this noise of the vertices. `hinges` and the
/// positions of their mesh have to outlive it.
std::unique_ptr<Residual> hinge_residual(const Hinges& hinges, std::span<const Vec3> positions, double scale,
                                         double noise);

} // namespace wm3d::detect
