// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/core/memory.hpp>

#include <cstdlib> // for __GLIBC__

#ifdef __GLIBC__
#include <malloc.h>
#endif

namespace wm3d {

void return_freed_memory() {
#ifdef __GLIBC__
    malloc_trim(0);
#endif
}

} // namespace wm3d
