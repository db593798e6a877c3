// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Accessors: typed arrays inside the buffers of a glTF asset.
#pragma once

#include "binary.hpp"
#include "gltf_file.hpp"

namespace wm3d::io {

/// A checked accessor: every element lies inside its buffer.
struct GltfAccessor {
    std::size_t number = 0;
    std::size_t buffer = 0;
    std::size_t offset = 0; ///< of the first element in the buffer
    std::size_t stride = 0;
    std::size_t count = 0;
    Scalar type = Scalar::f32;
    double unit = 1;     ///< what an integer is multiplied with: normalized types
    bool clamps = false; ///< signed normalized: the lowest integer means -1 as its neighbour does

    std::size_t end() const {
        return count == 0 ? offset : offset + (count - 1) * stride + 3 * size_of(type);
    }
};

/// \throw InputError  if it is no VEC3, compressed, sparse, or reaches out of its buffer
GltfAccessor gltf_position_accessor(GltfFile& file, std::size_t number);

/// Vertex numbers of an index accessor, each below `vertices`.
/// \throw InputError
std::vector<Index> gltf_indices(GltfFile& file, std::size_t number, std::size_t vertices);

} // namespace wm3d::io
