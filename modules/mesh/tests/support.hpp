// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  What the tests of the meshes share.
#pragma once

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::test {

/// A square of cells by cells squares, its vertices in no useful order.
inline TriangleMesh shuffled_square(Index cells) {
    const Index side = cells + 1, count = side * side;
    const auto number = [&](Index i, Index j) {
        return static_cast<Index>(std::size_t{i * side + j} * 7919 % count);
    };
    TriangleMesh mesh;
    mesh.positions.resize(count);
    for (Index i = 0; i < side; ++i)
        for (Index j = 0; j < side; ++j)
            mesh.positions[number(i, j)] = Vec3(i, j, 0);
    for (Index i = 0; i < cells; ++i)
        for (Index j = 0; j < cells; ++j) {
            mesh.triangles.push_back({number(i, j), number(i + 1, j), number(i + 1, j + 1)});
            mesh.triangles.push_back({number(i, j), number(i + 1, j + 1), number(i, j + 1)});
        }
    return mesh;
}

} // namespace wm3d::test
