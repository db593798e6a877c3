// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Choosing the signs of principal axes by another frame's.
#pragma once

#include <wm3d/mesh/frame.hpp>

namespace wm3d::resync {

/// The sign choice of `frame` whose axes are nearest to those of `like`.
Frame with_signs_of(const Frame& frame, const Frame& like);

} // namespace wm3d::resync
