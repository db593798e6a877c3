// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Smoothing by the umbrella operator U(v) = mean of the neighbours - v. Vertices of a border stay.
#pragma once

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::attack {

/// Laplacian smoothing: in each step all vertices at once move by lambda U(v). The benchmark's lambda is
/// 0.10.
TriangleMesh smooth_laplacian(const TriangleMesh& mesh, int steps, double lambda);

struct TaubinOptions {
    int steps = 10;       ///< pairs of a shrinking and an inflating step
    double lambda = 0.33; ///< shrinking factor, > 0
    double mu = -0.34;    ///< inflating factor, < -lambda: 1/lambda + 1/mu is the pass-band frequency
};

/// G. Taubin, "A signal processing approach to fair surface design" (SIGGRAPH 1995): smoothing that keeps
/// the low frequencies, and so the volume.
TriangleMesh smooth_taubin(const TriangleMesh& mesh, const TaubinOptions& options = {});

} // namespace wm3d::attack
