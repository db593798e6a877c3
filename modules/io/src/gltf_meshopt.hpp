// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Buffer views that EXT_meshopt_compression packed, as `gltfpack -c` writes them.
#pragma once

#include <cstddef>

#include "gltf_file.hpp"

namespace wm3d::io {

/// Number of the buffer that holds what a packed buffer view stands for: count elements of byteStride bytes.
/// \param extension  the view's EXT_meshopt_compression object
/// \throw InputError  if it can't be unpacked or grows beyond the asset's limits, or this build was made
///                    without meshoptimizer
std::size_t gltf_unpacked_view(GltfFile& file, std::size_t view, const Json& extension);

} // namespace wm3d::io
