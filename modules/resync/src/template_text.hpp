// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  A pose template as text.
#pragma once

#include <optional>
#include <string>
#include <string_view>

#include <wm3d/mesh/measure.hpp>
#include <wm3d/resync/pose_template.hpp>

namespace wm3d::resync {

/// Base64 of nine bytes per point: three 16-bit little-endian fractions of the box, three signed bytes of the
/// normal.
std::string encode(const PoseTemplate& pose_template, const Box& box);

/// None if the text isn't what `encode` makes.
std::optional<PoseTemplate> decode(std::string_view text, const Box& box);

} // namespace wm3d::resync
