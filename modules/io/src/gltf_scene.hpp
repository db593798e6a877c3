// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The scene graph: which meshes are shown, and where in the world.
#pragma once

#include <vector>

#include <wm3d/mesh/types.hpp>

#include "gltf_file.hpp"

namespace wm3d::io {

/// x becomes linear x + translation.
struct Placement {
    Mat3 linear = Mat3::Identity();
    Vec3 translation = Vec3::Zero();
    Vec3 operator()(const Vec3& p) const { return linear * p + translation; }
};

struct PlacedMesh {
    std::size_t mesh = 0;
    Placement placement;
};

/// Meshes of the default scene (the first if none is named, all root nodes if there are no scenes), in the
/// order of a walk from the roots. A skinned mesh stands in its own coordinates, as the format says. If no
/// node shows a mesh, every mesh stands once at the origin.
/// \throw InputError e.g. if nodes form a cycle
std::vector<PlacedMesh> gltf_placed_meshes(const GltfFile& file);

} // namespace wm3d::io
