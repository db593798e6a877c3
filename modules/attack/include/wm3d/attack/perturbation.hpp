// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Attacks that move each vertex on its own: noise and roundings. Definitions of noise and
/// quantization: K. Wang, G. Lavoue, F. Denis, A. Baskurt, "A benchmark for 3D mesh watermarking" (SMI 2010).
#pragma once

#include <cstdint>

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::attack {

/// The benchmark's unit of length d: mean distance of a vertex to the mean of all vertices.
double mean_vertex_distance(const TriangleMesh& mesh);

/// Adds to each coordinate a number uniform in +-`percent` % of d (`mean_vertex_distance`). Vertices of a
/// border stay where they are.
TriangleMesh add_noise(const TriangleMesh& mesh, double percent, std::uint64_t seed);

/// Rounds each coordinate to the nearest of 2^bits + 1 levels that divide the range of its axis evenly.
/// \pre  0 < bits <= 32
TriangleMesh quantize(const TriangleMesh& mesh, int bits);

/// Rounds each coordinate to a number of decimals, as text formats do. In units of the file.
TriangleMesh round_decimals(const TriangleMesh& mesh, int decimals);

} // namespace wm3d::attack
