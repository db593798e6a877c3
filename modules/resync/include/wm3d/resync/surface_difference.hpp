// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  What a suspect adds to a reference surface that it is aligned with.
#pragma once

#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::resync {

struct SurfaceDifference {
    std::vector<double>
        along_normal; ///< #reference vertices: signed distance of the suspect along the vertex normal
    std::vector<double> trust; ///< #reference vertices: 1, or 0 where the suspect has no counterpart
    double covered = 0;        ///< part of the reference's vertices that has one
};

/// Difference at each vertex of the reference: its normal times the way to the closest point of the suspect.
/// A vertex has no counterpart if that point lies on the suspect's border, farther than `reach`, or faces
/// another way.
/// \param suspect  in the coordinates of the reference
/// \throw GeometryError if the suspect has no area
/// \throw ParameterError if this build can't register
SurfaceDifference surface_difference(const TriangleMesh& reference, const TriangleMesh& suspect,
                                     double reach);

} // namespace wm3d::resync
