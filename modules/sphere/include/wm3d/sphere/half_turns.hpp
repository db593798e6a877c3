// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The sphere's half turns about the coordinate axes, and its inversion: each takes every vertex to a
/// vertex.
#pragma once

#include <array>
#include <optional>
#include <vector>

#include <wm3d/sphere/icosphere.hpp>

namespace wm3d::sphere {

/// For each half turn about x, y, z: the number of the vertex to which it takes vertex j. That of a coarser
/// level is the beginning of this one, as its vertices are.
std::array<std::vector<Index>, 3> half_turns(const Icosphere& sphere);

/// For each vertex the number of the one opposite.
std::vector<Index> inversion(const Icosphere& sphere);

/// The axis, 0 to 2, of the half turn about a coordinate axis that a rotation is; none if it is no such turn.
std::optional<int> half_turn_axis(const Mat3& rotation);

} // namespace wm3d::sphere
