// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The triangles of a primitive.
#pragma once

#include <vector>

#include <wm3d/mesh/types.hpp>

#include "gltf_file.hpp"

namespace wm3d::io {

/// Whether a primitive has triangles at all; points and lines are no surface.
/// \throw InputError
bool gltf_is_surface(const Source& source, const Json& primitive);

/// Triangles of a primitive over its own `vertices`, whose mode is triangles, a strip or a fan.
/// \throw InputError
std::vector<Triangle> gltf_triangles(GltfFile& file, const Json& primitive, std::size_t vertices);

} // namespace wm3d::io
