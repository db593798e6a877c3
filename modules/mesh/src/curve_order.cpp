// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/mesh/curve_order.hpp>

#include <algorithm>
#include <cmath>
#include <utility>

#include <wm3d/core/filed.hpp>
#include <wm3d/core/parallel.hpp>
#include <wm3d/mesh/measure.hpp>

namespace wm3d {

namespace {

constexpr std::size_t renumbered_block = 16384; ///< of vertices or triangles

constexpr double cells = 1u << morton_bits; // along each axis

/// Spreads the low 11 bits of x to every third bit.
std::uint64_t spread(std::uint64_t x) {
    x = (x | (x << 16)) & 0x001f0000ff0000ffu;
    x = (x | (x << 8)) & 0x100f00f00f00f00fu;
    x = (x | (x << 4)) & 0x10c30c30c30c30c3u;
    x = (x | (x << 2)) & 0x1249249249249249u;
    return x;
}

/// Numbers of the vertices, along the curve.
std::vector<Index> vertices_along_curve(const TriangleMesh& mesh) {
    const Box box = surface_box(mesh);
    const Vec3 centre = 0.5 * box.min + 0.5 * box.max;
    const double side = (box.max - box.min).maxCoeff();
    const double scale = side > 0 && std::isfinite(side) ? side : 1;
    std::vector<std::pair<std::uint64_t, Index>> keys(mesh.positions.size());
    const auto middle = keys.begin() + static_cast<std::ptrdiff_t>(keys.size() / 2);
    const auto sort = [&](auto begin, auto end) {
        for (auto key = begin; key != end; ++key) {
            const auto v = static_cast<Index>(key - keys.begin());
            *key = {morton_code((mesh.positions[v] - centre) / scale), v};
        }
        std::sort(begin, end);
    };
    parallel_invoke([&] { sort(keys.begin(), middle); }, [&] { sort(middle, keys.end()); });
    std::inplace_merge(keys.begin(), middle, keys.end());
    std::vector<Index> vertices(keys.size());
    std::ranges::transform(keys, vertices.begin(), [](const auto& key) { return key.second; });
    return vertices;
}

/// The triangles by their least corner, those of one in the order in which they come.
std::vector<Triangle> by_least_corner(const std::vector<Triangle>& triangles, std::size_t vertices) {
    return filed<Triangle>(vertices, triangles.size(),
                           [&](auto&& file) {
                               for (const Triangle& t : triangles)
                                   file(std::ranges::min(t), [&] { return t; });
                           })
        .values;
}

} // namespace

std::uint64_t morton_code(const Vec3& unit) {
    std::uint64_t code = 0;
    for (int k = 0; k < 3; ++k) {
        const double cell = std::clamp((unit[k] + 0.5) * cells, 0.0, cells - 1);
        code |= spread(static_cast<std::uint64_t>(cell)) << k;
    }
    return code;
}

Reordered along_curve(const TriangleMesh& mesh) {
    Reordered result{{}, vertices_along_curve(mesh)};
    std::vector<Index> number(result.original.size());
    result.mesh.positions.resize(number.size());
    parallel_blocks(number.size(), renumbered_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i) {
            number[result.original[i]] = static_cast<Index>(i);
            result.mesh.positions[i] = mesh.positions[result.original[i]];
        }
    });
    std::vector<Triangle> renumbered(mesh.triangles.size());
    parallel_blocks(renumbered.size(), renumbered_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f)
            for (std::size_t k = 0; k < 3; ++k)
                renumbered[f][k] = number[mesh.triangles[f][k]];
    });
    result.mesh.triangles = by_least_corner(renumbered, number.size());
    return result;
}

} // namespace wm3d
