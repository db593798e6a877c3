// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  From a function to a surface: dual contouring, so that creases stay sharp.
#pragma once

#include <functional>

#include <wm3d/mesh/measure.hpp>
#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::shapes {

/// A solid as a function that is negative inside and whose slope is 1 or a little less (a distance bound).
using Solid = std::function<double(const Vec3&)>;

struct ContourOptions {
    double cell = 0.1;         ///< side of the grid's cubes, in units of the solid
    int relaxation_sweeps = 8; ///< moves of smooth vertices to the middle of their neighbours
    double crease_threshold =
        .1; ///< ratio of second to first eigenvalue of the cell's normals that makes a crease
};

/// The surface of `solid` inside `box`: one vertex per grid cube that the surface crosses, on creases and
/// corners where the cube holds one. Closed and manifold if every part and every gap of the solid is about
/// three cells thick and the surface stays clear of the box's sides. Calls `solid` from several threads.
///
/// This work is based on T. Ju, F. Losasso, S. Schaefer, J. Warren, "Dual contouring of Hermite data" (2002).
/// \throw ParameterError  if the cell is not positive or the box has over 2^40 cells
TriangleMesh contour(const Solid& solid, const Box& box, const ContourOptions& options);

} // namespace wm3d::shapes
