// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Diffusion on dense surfaces: conjugate gradients whose steps don't grow in number with the density.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>

#include "diffusion_levels.hpp"

namespace wm3d::detect {

/// The system M + tL with a hierarchy over it. Conjugate gradients are preconditioned by a V-cycle over the levels
/// (W. L. Briggs, V. E. Henson, S. F. McCormick, "A Multigrid Tutorial", 2000), with a damped Jacobi step on either way.
/// Vectors that are solved for together share each pass over the matrix. Solutions and sums are in double precision, what is
/// corrected from step to step in single. The same bytes at any number of threads.
class MultilevelDiffusion {
public:
    /// \param mass  diagonal of M, #V, all > 0
    MultilevelDiffusion(const TriangleMesh& mesh, std::span<const double> mass);

    /// Solves (M + tL) x = M f for each vector, #V, which is f when called and the solution afterwards. Ends when the error
    /// of each, as the V-cycle tells its energy, is at most `tolerance` times f (both over the area), or after `most` steps:
    /// a residual would ask for more the denser the surface is, and for nothing that the solution shows.
    /// \return  steps taken, over all that were taken together
    int diffuse(double t, std::span<std::vector<double>> vectors, double tolerance, int most) const;

private:
    double unit_ = 1; ///< mean mass: what is in single precision is of the order of 1 in any unit of length
    std::vector<DiffusionLevel> levels_;
};

} // namespace wm3d::detect
