// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/mesh/sides.hpp>

#include <algorithm>
#include <tuple>
#include <utility>

#include <wm3d/core/filed.hpp>
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

/// \param place_of  from a lower end to its place among `count`, or to no_index
template<typename Place>
std::vector<Side> sides_by_place(const TriangleMesh& mesh, std::size_t count, Place&& place_of) {
    // Filed under their lower ends: what is left to sort are the few at one vertex.
    Filed<Side> by_low = filed<Side>(count, mesh.triangles.size(), [&](auto&& file) {
        for_each_side(mesh, [&](const Side& s) { file(place_of(s.low), [&] { return s; }); });
    });
    parallel_blocks(count, 4096, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v)
            std::ranges::sort(by_low.under(v), [](const Side& s, const Side& t) {
                return std::tie(s.high, s.forward) < std::tie(t.high, t.forward);
            });
    });
    return std::move(by_low.values);
}

} // namespace

std::vector<Side> sorted_sides(const TriangleMesh& mesh) {
    return sides_by_place(mesh, mesh.positions.size(), [](Index low) { return low; });
}

std::vector<Side> sorted_sides(const TriangleMesh& mesh, std::span<const Index> lows) {
    std::vector<Index> place(mesh.positions.size(), no_index);
    for (std::size_t i = 0; i < lows.size(); ++i)
        place[lows[i]] = static_cast<Index>(i);
    return sides_by_place(mesh, lows.size(), [&](Index low) { return place[low]; });
}

} // namespace wm3d
