// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  What the tests of payloads share.
#pragma once

namespace wm3d::payload::test {

/// The largest move of a sphere's vertex, as keys have it unless they say otherwise.
inline constexpr double rmax = 0.1;

} // namespace wm3d::payload::test
