// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The mean of the vertices, the fixed point of the attacks that move space.
#pragma once

#include <wm3d/core/parallel.hpp>
#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::attack {

/// \pre  the mesh has a vertex
inline Vec3 vertex_mean(const TriangleMesh& mesh) {
    const Vec3 zero = Vec3::Zero();
    const Vec3 sum =
        parallel_sum(mesh.positions.size(), 16384, zero, [&](std::size_t begin, std::size_t end) -> Vec3 {
            Vec3 part = Vec3::Zero();
            for (std::size_t v = begin; v < end; ++v)
                part += mesh.positions[v];
            return part;
        });
    return sum / static_cast<double>(mesh.positions.size());
}

} // namespace wm3d::attack
