// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Buffer views that EXT_meshopt_compression packed, as `gltfpack -c` writes them.
#pragma once

#include <string>

#include "gltf_file.hpp"

namespace wm3d::io {

/// The bytes that a packed buffer view stands for: count elements of byteStride bytes.
/// \param extension  the view's EXT_meshopt_compression object
/// \throw InputError  if they can't be unpacked, or this build was made without meshoptimizer
std::string gltf_unpacked(GltfFile& file, std::size_t view, const Json& extension);

} // namespace wm3d::io
