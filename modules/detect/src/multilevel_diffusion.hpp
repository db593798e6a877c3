// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Diffusion on dense surfaces: conjugate gradients whose steps don't grow in number with the density.
#pragma once

#include <span>
#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>

#include "symmetric_rows.hpp"

namespace wm3d::detect {

/// The system M + tL with a hierarchy over it, by aggregation: a vertex and its neighbours are one row of the next level,
/// and so on. Conjugate gradients are preconditioned by a V-cycle over the levels (W. L. Briggs, V. E. Henson,
/// S. F. McCormick, "A Multigrid Tutorial", 2000), with a damped Jacobi step on either way. Entries are in single
/// precision, the vectors that add up in double. The same bytes at any number of threads.
class MultilevelDiffusion {
public:
    /// \param mass  diagonal of M, #V, all > 0
    MultilevelDiffusion(const TriangleMesh& mesh, std::span<const double> mass);

    /// Solves (M + tL) x = M f; `x` is f when called and the solution afterwards. Ends when the residual is at most `tolerance`
    /// times the right-hand side, or after `most` steps.
    /// \return  steps taken
    int diffuse(double t, std::vector<double>& x, double tolerance, int most) const;

private:
    struct Level {
        std::vector<float> mass; ///< over `unit_`
        SymmetricRowsOf<float> laplacian;
        std::vector<Index> parent; ///< of each row, on the next level; none on the last
    };
    struct Scratch {
        std::vector<float> right, solution, residual;
    };

    void cycle(float t, std::size_t level, std::vector<Scratch>& at) const;

    double unit_ = 1; ///< mean mass: what is in single precision is of the order of 1 in any unit of length
    std::vector<Level> levels_;
};

} // namespace wm3d::detect
