// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Where to put a mark's strength so that the whitened detector finds it after smoothing, noise and
/// coarsening. The bumps of the paper spend it evenly; docs/detector.md says what each part of the blend
/// gives.
#pragma once

#include <span>
#include <vector>

#include <wm3d/detect/evidence.hpp>
#include <wm3d/mesh/triangle_mesh.hpp>
#include <wm3d/sphere/sparse_rows.hpp>

namespace wm3d::shaping {

/// A template taken after smoothing.
struct SmoothedShare {
    int steps = 0; ///< of the umbrella operator on the full mesh; 0 is the mesh as it is
    double share = 0;
};

/// Shares of the parts, each of which has the same root mean square before they are added.
struct Blend {
    double bumps = 0.3; ///< the paper's own
    std::vector<SmoothedShare> templates{{0, 0.3}, {30, 0.25}, {50, 0.2}};
    double weight = 0.1; ///< of a smoothing step
    /// No template moves a vertex by more than this many times its root mean square: a tiny triangle could
    /// take all.
    double most = 4;
    /// The filter whose template is taken: the finest of the detector's bank puts most where the surface is
    /// smooth.
    detect::Filter filter{3e-5, 1.0, 3e-4};
};

/// Moves along the vertex normals, #base, of area-weighted root mean square 1: the blend for the mark of `w`.
/// Everywhere 0 if no bump shows along a normal.
/// \param base     base domain in the canonical frame
/// \param rows     B for its vertices
/// \param rms      root mean square move that is meant, in mean radii: the templates are those of the marked
///        mesh
/// \param density  base vertices over vertices of the full mesh, at most 1: a smoothing step spreads over the
///        edges of the full mesh, so fewer steps do the same to the base
std::vector<double> normal_moves(const TriangleMesh& base, const sphere::SparseRows& rows,
                                 std::span<const double> w, double rms, double density,
                                 const Blend& blend = {});

} // namespace wm3d::shaping
