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

/// \param place_of  from a lower end to its place among `count`, or to no_index
template<typename Place>
std::vector<Side> filed_sides(const TriangleMesh& mesh, std::size_t count, Place&& place_of) {
    // Filed under their lower ends: what is left to sort are the few at one vertex.
    std::vector<std::size_t> end(count + 1, 0);
    const auto shared = [&](auto&& visit) { // by the lower ends that each thread files
        parallel_shares(count, mesh.triangles.size(), [&](std::size_t first, std::size_t last) {
            for_each_side(mesh, [&](const Side& s) {
                if (const Index place = place_of(s.low); place >= first && place < last)
                    visit(s, place);
            });
        });
    };
    shared([&](const Side&, Index place) { ++end[place + 1]; });
    std::partial_sum(end.begin(), end.end(), end.begin());
    std::vector<Side> sides(end.back());
    shared([&](const Side& s, Index place) { sides[end[place]++] = s; });
    parallel_blocks(count, 4096, [&](std::size_t first, std::size_t last) {
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

} // namespace

std::vector<Side> sorted_sides(const TriangleMesh& mesh) {
    return filed_sides(mesh, mesh.positions.size(), [](Index low) { return low; });
}

std::vector<Side> sorted_sides(const TriangleMesh& mesh, std::span<const Index> lows) {
    std::vector<Index> place(mesh.positions.size(), no_index);
    for (std::size_t i = 0; i < lows.size(); ++i)
        place[lows[i]] = static_cast<Index>(i);
    return filed_sides(mesh, lows.size(), [&](Index low) { return place[low]; });
}

} // namespace wm3d
