// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  A mesh, moved by a similarity.
#pragma once

#include <wm3d/mesh/triangle_mesh.hpp>
#include <wm3d/resync/similarity.hpp>

namespace wm3d::resync::test {

inline TriangleMesh moved(TriangleMesh mesh, const Similarity& t) {
    for (Vec3& p : mesh.positions)
        p = t(p);
    return mesh;
}

} // namespace wm3d::resync::test
