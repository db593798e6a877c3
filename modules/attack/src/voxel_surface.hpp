// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The one function of the shared library wm3d_voxels, which alone is linked with OpenVDB.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <wm3d/mesh/types.hpp>

namespace wm3d::attack {

/// Faces between the inner and the outer voxels of a grid.
struct VoxelSurface {
    std::vector<Eigen::Vector3f> points;
    std::vector<std::array<Index, 4>> quads; ///< clockwise seen from outside
};

/// \param points     of a closed surface, in voxels
/// \param triangles  of it
using ExtractSurface = void(std::span<const Eigen::Vector3f> points, std::span<const Triangle> triangles,
                            VoxelSurface& surface);

/// Loads the library at the first call: resolving OpenVDB's symbols takes longer than most commands.
/// \throw ParameterError  if it can't be loaded
ExtractSurface& extract_surface();

} // namespace wm3d::attack

extern "C" wm3d::attack::ExtractSurface wm3d_extract_surface;
