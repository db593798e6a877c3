// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Accessors that stand in each other's way.
#pragma once

#include <cstddef>
#include <optional>
#include <utility>
#include <vector>

#include "gltf_accessor.hpp"

namespace wm3d::io {

/// Numbers of two accessors of three components whose elements share bytes; nothing if there are none, as
/// where the elements of one lie in the gaps of the other. Accessors that reach over each other with
/// different strides count as sharing. In O(n log n).
std::optional<std::pair<std::size_t, std::size_t>> gltf_overlap(std::vector<GltfAccessor> accessors);

} // namespace wm3d::io
