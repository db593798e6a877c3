// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  What the allocator keeps.
#pragma once

namespace wm3d {

/// Gives memory that was freed back to the system, where the allocator can: after work that took much of it in small
/// blocks, before work that takes as much in large ones.
void return_freed_memory();

} // namespace wm3d
