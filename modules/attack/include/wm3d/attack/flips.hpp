// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Re-triangulation of the same vertices by edge flips (figure 1 of the paper).
#pragma once

#include <cstdint>

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::attack {

/// What keeps a flip from harming the surface: both old and both new triangles lie within `max_angle` degrees
/// of their common normal, the new edge doesn't exist yet, and the edge has exactly two triangles.
struct FlipOptions {
    double max_angle = 20;
};

struct Flipped {
    TriangleMesh mesh;
    std::size_t flips = 0;
};

/// Visits the edges in random order and flips those that may be, until `percent` % of all edges are flipped
/// or every edge was visited. Vertices, their order and the Euler number stay.
Flipped flip_random(const TriangleMesh& mesh, double percent, std::uint64_t seed,
                    const FlipOptions& options = {});

/// Flips edges whose two opposite angles sum to more than 180 degrees until none is left or 10 flips per edge
/// were done: towards the Delaunay triangulation of the surface.
Flipped flip_delaunay(const TriangleMesh& mesh, const FlipOptions& options = {});

} // namespace wm3d::attack
