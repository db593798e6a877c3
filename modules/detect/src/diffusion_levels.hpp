// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The levels of a multilevel diffusion.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>

#include "symmetric_rows.hpp"

namespace wm3d::detect {

/// Rows that are taken together: neither sums nor the steps of a sweep depend on the number of threads.
constexpr std::size_t level_block = 8192;

/// The rows that each row of the next level stands for, ascending.
struct Members {
    std::vector<Index> start; ///< #rows of the next level + 1
    std::vector<Index> row;   ///< #rows

    std::span<const Index> of(std::size_t aggregate) const {
        return {row.data() + start[aggregate], start[aggregate + 1] - start[aggregate]};
    }
};

/// M and L of a level.
struct DiffusionLevel {
    std::vector<float> mass;
    SymmetricRowsOf<float> laplacian;
    Members members; ///< none on the last level
};

/// Levels by aggregation, the finest first: a vertex and its neighbours are one row of the next level, and so on.
/// \param mass  diagonal of M, #V, all > 0
/// \param unit  of mass
std::vector<DiffusionLevel> diffusion_levels(const TriangleMesh& mesh, std::span<const double> mass,
                                             double unit);

} // namespace wm3d::detect
