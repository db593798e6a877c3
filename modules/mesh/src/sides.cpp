// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/mesh/sides.hpp>

#include <numeric>
#include <tuple>

#include <wm3d/core/parallel.hpp>

namespace wm3d {

namespace {

/// Calls visit(side) for the sides of all triangles.
template<typename Visitor>
void for_each_side(const TriangleMesh& mesh, Visitor&& visit) {
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
        const Triangle& t = mesh.triangles[f];
        for (std::size_t k = 0; k < 3; ++k) {
            const Index a = t[k], b = t[(k + 1) % 3];
            if (a != b)
                visit(Side{std::min(a, b), std::max(a, b), a < b, static_cast<Index>(f)});
        }
    }
}

} // namespace

std::vector<Side> sorted_sides(const TriangleMesh& mesh) {
    return sorted_sides(mesh, 0, mesh.positions.size());
}

std::vector<Side> sorted_sides(const TriangleMesh& mesh, std::size_t begin_low, std::size_t end_low) {
    // Filed under their lower ends: what is left to sort are the few at one vertex.
    const std::size_t vertices = end_low - begin_low;
    std::vector<std::size_t> end(vertices + 1, 0);
    const auto for_each = [&](auto&& visit) {
        for_each_side(mesh, [&](const Side& s) {
            if (s.low >= begin_low && s.low < end_low)
                visit(s, s.low - begin_low);
        });
    };
    for_each([&](const Side&, std::size_t low) { ++end[low + 1]; });
    std::partial_sum(end.begin(), end.end(), end.begin());
    std::vector<Side> sides(end.back());
    for_each([&](const Side& s, std::size_t low) { sides[end[low]++] = s; });
    parallel_blocks(vertices, 4096, [&](std::size_t first, std::size_t last) {
        for (std::size_t v = first; v < last; ++v) {
            const auto begin = static_cast<std::ptrdiff_t>(v == 0 ? 0 : end[v - 1]);
            std::sort(sides.begin() + begin, sides.begin() + static_cast<std::ptrdiff_t>(end[v]),
                      [](const Side& s, const Side& t) {
                          return std::tie(s.high, s.forward) < std::tie(t.high, t.forward);
                      });
        }
    });
    return sides;
}

} // namespace wm3d
