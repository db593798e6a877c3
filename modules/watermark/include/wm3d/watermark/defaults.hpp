// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Choices that mark and verify share, so that a key file is all that verify needs.
/// docs/algorithm.md gives the measurements behind each.
#pragma once

#include <cstddef>
#include <string_view>

#include <wm3d/key/key_file.hpp>

namespace wm3d::watermark {

/// How a mark is laid out.
enum class Profile {
    masked, ///< at every vertex along its normal, as strong as its surroundings hide
    robust, ///< on the base domain along its normals, shaped for what the detector sees after attacks
    paper,  ///< on the base domain, the bumps themselves along the radius, eq. (3)
};

std::string_view name(Profile profile);

/// One-sided MSDM2 that a mark keeps to when nothing else is said.
inline constexpr double default_visibility = 0.10;

/// Normal move, area-weighted RMS in % of the bounding box's diagonal, of a mark of the paper's kind that is
/// asked for without strength.
inline constexpr double default_strength = 0.05;

/// Strength, in % of the diagonal, of bumps on the base domain that score about what a masked mark of the
/// default visibility does on a scan: predictions of power take no key's marks for stronger.
inline constexpr double usual_strength = 0.01;

/// False-positive probability of a verdict that is asked for without one.
inline constexpr double default_pf = 1e-6;

/// Vertices of the base domain and of the simplified suspect: about two per sphere vertex of level 5.
inline constexpr std::size_t default_vertices = 20000;

/// Level of the watermarking sphere for a mesh: of the key's levels the one nearest to 5, or to 4 where the
/// mesh has fewer vertices than the sphere of level 5 (masked: of level 4); the coarser of two that are
/// equally near.
unsigned default_level(const key::PublicParameters& parameters, std::size_t vertices,
                       Profile profile = Profile::masked);

} // namespace wm3d::watermark
