// SPDX-License-Identifier: GPL-3.0-or-later
#include "corners.hpp"

namespace wm3d::simplify {

Corners corners_by_vertex(const std::vector<Triangle>& triangles, std::size_t vertices) {
    Corners by;
    by.start.assign(vertices + 1, 0);
    for (const Triangle& t : triangles)
        for (Index v : t)
            ++by.start[v + 1];
    for (std::size_t v = 0; v < vertices; ++v)
        by.start[v + 1] += by.start[v];
    by.corners.resize(3 * triangles.size());
    std::vector<Index> at(by.start.begin(), by.start.end() - 1);
    for (std::size_t f = 0; f < triangles.size(); ++f)
        for (Index k = 0; k < 3; ++k)
            by.corners[at[triangles[f][k]]++] = static_cast<Index>(3 * f) + k;
    return by;
}

} // namespace wm3d::simplify
