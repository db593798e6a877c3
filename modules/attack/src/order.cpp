// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/attack/order.hpp>

#include <vector>

#include <wm3d/attack/random.hpp>

#include "permutation.hpp"

namespace wm3d::attack {

TriangleMesh reorder(const TriangleMesh& mesh, std::uint64_t seed) {
    const std::vector<Index> vertex_order = random_permutation(mesh.positions.size(), RandomStream(seed, 0));
    const std::vector<Index> triangle_order =
        random_permutation(mesh.triangles.size(), RandomStream(seed, 1));
    const RandomStream corners(seed, 2);

    TriangleMesh shuffled;
    shuffled.positions.reserve(mesh.positions.size());
    std::vector<Index> new_number(mesh.positions.size());
    for (Index old : vertex_order) {
        new_number[old] = static_cast<Index>(shuffled.positions.size());
        shuffled.positions.push_back(mesh.positions[old]);
    }
    shuffled.triangles.reserve(mesh.triangles.size());
    for (Index old : triangle_order) {
        const Triangle& t = mesh.triangles[old];
        const std::uint64_t turn = corners.below(old, 3);
        shuffled.triangles.push_back(
            {new_number[t[turn]], new_number[t[(turn + 1) % 3]], new_number[t[(turn + 2) % 3]]});
    }
    return shuffled;
}

} // namespace wm3d::attack
