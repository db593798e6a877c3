// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/mesh/centre.hpp>

#include <wm3d/core/parallel.hpp>

namespace wm3d {

Vec3 vertex_mean(const TriangleMesh& mesh) {
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

} // namespace wm3d
