// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  A mesh as a new glTF asset.
#pragma once

#include <string>

#include <wm3d/io/encode.hpp>

namespace wm3d::io {

/// GLB if `binary`, otherwise .gltf with its buffer inline. Colours have been checked.
std::string encode_gltf(const TriangleMesh& mesh, const EncodeOptions& options, bool binary);

} // namespace wm3d::io
