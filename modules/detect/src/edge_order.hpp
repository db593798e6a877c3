// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  What triangles say of their sides, edge by edge, without a comparison.
#pragma once

#include <algorithm>
#include <cstddef>
#include <span>
#include <utility>

#include <wm3d/core/filed.hpp>
#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::detect {

/// What a triangle says of a side, as seen from one of its ends.
template<typename Value>
struct Spoke {
    Index other; ///< end
    Value value;
};

/// The spokes at the higher ends of sides, in the order of the triangles.
template<typename Value, typename ValueAcross>
Filed<Spoke<Value>> downward_spokes(const TriangleMesh& mesh, ValueAcross across) {
    return filed<Spoke<Value>>(mesh.positions.size(), mesh.triangles.size(), [&](auto&& file) {
        for (std::size_t f = 0; f < mesh.triangles.size(); ++f)
            for (std::size_t k = 0; k < 3; ++k) {
                const Index a = mesh.triangles[f][(k + 1) % 3], b = mesh.triangles[f][(k + 2) % 3];
                if (a != b)
                    file(std::max(a, b), [&] { return Spoke<Value>{std::min(a, b), across(f, k)}; });
            }
    });
}

/// The spokes at the lower ends of sides, by their other ends, and those of one edge in the order of its triangles.
/// \param across  across(f, k) is the value of the side across from corner k of triangle f; gone before memory is
///                taken for the result
template<typename Value, typename ValueAcross>
Filed<Spoke<Value>> upward_spokes(const TriangleMesh& mesh, ValueAcross across) {
    // Filing keeps the order in which values come: after the higher ends, the lower.
    const Filed<Spoke<Value>> downward = downward_spokes<Value>(mesh, std::move(across));
    return filed<Spoke<Value>>(mesh.positions.size(), mesh.triangles.size(), [&](auto&& file) {
        for (Index high = 0; high < mesh.positions.size(); ++high)
            for (const Spoke<Value>& s : downward.under(high))
                file(s.other, [&] { return Spoke<Value>{high, s.value}; });
    });
}

/// Calls visit(low, high, spokes) for every edge in ascending order.
/// \param upward  of `upward_spokes`
template<typename Value, typename Visitor>
void for_each_edge(const Filed<Spoke<Value>>& upward, Visitor&& visit) {
    for (Index low = 0; low + 1 < upward.start.size(); ++low) {
        const std::span<const Spoke<Value>> spokes = upward.under(low);
        for (std::size_t first = 0; first < spokes.size();) {
            std::size_t last = first + 1;
            while (last < spokes.size() && spokes[last].other == spokes[first].other)
                ++last;
            visit(low, spokes[first].other, spokes.subspan(first, last - first));
            first = last;
        }
    }
}

} // namespace wm3d::detect
