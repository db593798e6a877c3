// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  What the tests of masking share.
#pragma once

namespace wm3d::masking::test {

/// Of the sphere that the tests' marks are laid on.
inline constexpr unsigned level = 4;

} // namespace wm3d::masking::test
