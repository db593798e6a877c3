// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/mesh/weld.hpp>

#include <bit>

#include <wm3d/core/error.hpp>

namespace wm3d {

namespace {

std::uint64_t hash(const Vec3& p) {
    std::uint64_t h = 0x9e3779b97f4a7c15u;
    for (int k = 0; k < 3; ++k) {
        h ^= std::bit_cast<std::uint64_t>(p[k] + 0.0); // -0 becomes 0
        h *= 0xff51afd7ed558ccdu;
        h ^= h >> 32;
    }
    return h;
}

/// Number of the first point equal to each point, by open addressing.
std::vector<Index> first_equal(std::span<const Vec3> positions) {
    const std::size_t mask = std::bit_ceil(positions.size() * 2 + 1) - 1;
    std::vector<Index> table(mask + 1, no_index);
    std::vector<Index> first(positions.size());
    for (std::size_t i = 0; i < positions.size(); ++i) {
        std::size_t slot = hash(positions[i]) & mask;
        while (table[slot] != no_index && positions[table[slot]] != positions[i])
            slot = (slot + 1) & mask;
        if (table[slot] == no_index)
            table[slot] = static_cast<Index>(i);
        first[i] = table[slot];
    }
    return first;
}

} // namespace

Welded weld(std::span<const Vec3> positions, std::span<const Triangle> triangles) {
    if (positions.size() >= no_index)
        throw GeometryError(
            "the mesh has more than 4 294 967 294 vertices, which is more than wm3d can number");
    Welded welded;
    welded.vertex_of = first_equal(positions);
    for (std::size_t i = 0; i < positions.size(); ++i) {
        Index& v = welded.vertex_of[i];
        if (v == i) {
            v = static_cast<Index>(welded.mesh.positions.size());
            welded.mesh.positions.push_back(positions[i]);
        } else {
            v = welded.vertex_of[v]; // already renumbered: it comes earlier
        }
    }
    welded.mesh.triangles.reserve(triangles.size());
    for (const Triangle& t : triangles) {
        const Triangle w{welded.vertex_of[t[0]], welded.vertex_of[t[1]], welded.vertex_of[t[2]]};
        if (w[0] != w[1] && w[1] != w[2] && w[2] != w[0])
            welded.mesh.triangles.push_back(w);
    }
    return welded;
}

} // namespace wm3d
