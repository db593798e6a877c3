// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Detection with the original at hand: what the suspect adds to the reference surface, whitened in
/// bands.
#pragma once

#include <span>
#include <vector>

#include <wm3d/detect/linear_statistic.hpp>
#include <wm3d/mesh/triangle_mesh.hpp>
#include <wm3d/sphere/sparse_rows.hpp>

namespace wm3d::detect {

struct ReferenceOptions {
    /// Diffusion times between the bands, ascending, in units of mean radius squared. Noise lives in the
    /// first band, smoothing and simplification in the last; the mark in all.
    std::vector<double> times{3e-5, 1e-4, 3e-4, 1e-3, 3e-3, 1e-2};
    double variance_spread = 10; ///< the local variance of a band is averaged over its own time, times this
    double variance_floor = 1;   ///< added to the local variance, as part of its median
};

/// The difference of a suspect from its reference as evidence. No host is left in it, so low frequencies
/// count too; what smoothing or coarsening of the reference itself would look like is taken out by least
/// squares.
class ReferenceEvidence {
public:
    /// \param reference   in the canonical frame of the mark
    /// \param difference  #V: signed distance of the suspect along the vertex normals, in mean radii
    /// \param trust       #V: 0 where the suspect has no counterpart, else 1
    ReferenceEvidence(const TriangleMesh& reference, std::span<const double> difference,
                      std::span<const double> trust, const ReferenceOptions& options = {});

    /// T = sum_j c_j w_j with c = B^T diag(d.n) sum_k H_k^T (a g_k H_k e): e the difference, H_k the band
    /// passes, g_k the inverse local variance of band k, in units of what white noise has there, a the vertex
    /// areas.
    LinearStatistic statistic(const sphere::SparseRows& rows, double rmax) const;

private:
    std::vector<double> weighed_; ///< diag(d.n) sum_k H_k^T (a g_k H_k e)
};

} // namespace wm3d::detect
