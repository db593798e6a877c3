// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  How the commands get their memory from the system. A program decides that, so the library doesn't.
#pragma once

namespace wm3d::cmd {

/// Tells the allocator which blocks to keep when they are freed. To be called before there are threads.
void set_up_memory();

} // namespace wm3d::cmd
