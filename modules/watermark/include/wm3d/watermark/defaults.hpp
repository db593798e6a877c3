// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Choices that mark and verify share, so that a key file is all that verify needs.
/// docs/algorithm.md gives the measurements behind each.
#pragma once

#include <cstddef>

#include <wm3d/key/key_file.hpp>

namespace wm3d::watermark {

/// Normal move, area-weighted RMS in % of the bounding box's diagonal, of a mark that is asked for without
/// strength.
inline constexpr double default_strength = 0.05;

/// False-positive probability of a verdict that is asked for without one.
inline constexpr double default_pf = 1e-6;

/// Vertices of the base domain and of the simplified suspect: about two per sphere vertex of level 5.
inline constexpr std::size_t default_vertices = 20000;

/// Level of the watermarking sphere for a mesh: of the key's levels the one nearest to 5, or to 4 where the
/// mesh has fewer vertices than the sphere of level 5; the coarser of two that are equally near.
unsigned default_level(const key::PublicParameters& parameters, std::size_t vertices);

} // namespace wm3d::watermark
