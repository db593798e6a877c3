// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Repeatable variety for shapes; it needs no secrecy.
#pragma once

#include <cstdint>

#include <wm3d/mesh/types.hpp>

namespace wm3d::shapes {

/// The next number of a SplitMix64 sequence, mapped to [-1, 1).
double signed_unit(std::uint64_t& state);

/// Smooth noise of about [-1, 1] with zeros at the points of the integer lattice and waves of length 1 to 2:
/// slopes drawn at the lattice points, blended by a quintic.
double gradient_noise(const Vec3& p, std::uint64_t seed);

} // namespace wm3d::shapes
