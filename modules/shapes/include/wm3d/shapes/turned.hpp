// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Closed solids around the z axis: shapes whose principal axes don't tell how they are turned.
#pragma once

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::shapes {

/// A vase of revolution, closed at the top, with a fine relief that nearly repeats around it. About
/// `vertices`.
TriangleMesh vase(std::size_t vertices);

/// A flat wheel with teeth; a quarter of a turn or less takes it to itself. About `vertices`.
TriangleMesh gear(int teeth, std::size_t vertices);

/// A flat disc whose faces are a little domed. About `vertices`.
TriangleMesh disc(std::size_t vertices);

} // namespace wm3d::shapes
