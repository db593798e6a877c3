// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The demonstration model.
#pragma once

#include <cstddef>
#include <cstdint>

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::shapes {

/// Fewest and most triangles of `sample`.
inline constexpr std::size_t sample_min_faces = 2'000;
inline constexpr std::size_t sample_max_faces = 5'000'000;

/// A ewer on a stepped plinth, 300 mm tall, as a scan of it would be: helical gadroons with sharp valleys, a
/// thin strap handle, a spout, a hollow neck with a thin wall, square steps, fine relief all over. Closed,
/// connected, manifold, not star-shaped, with three distinct principal axes. `faces` is met within a few
/// percent; parts too thin for the size of the triangles are made thicker. `seed` draws the relief; same
/// numbers, same mesh.
/// \throw ParameterError if `faces` is out of range
TriangleMesh sample(std::size_t faces, std::uint64_t seed);

} // namespace wm3d::shapes
