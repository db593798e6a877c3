// SPDX-License-Identifier: GPL-3.0-or-later
#include "memory.hpp"

#include <algorithm>
#include <cstddef>
#include <cstdlib>
#include <new>

#ifdef __GLIBC__
#include <malloc.h>
#include <sys/mman.h>
#endif

namespace wm3d::cmd {

namespace {

constexpr std::size_t large = 2 << 20; ///< bytes; also those of a large page

} // namespace

void set_up_memory() {
#ifdef __GLIBC__
    // Else each large block that is freed teaches glibc to keep the next: a sixth of verify's memory on dense models.
    mallopt(M_MMAP_THRESHOLD, large);
    // And each smaller one that is freed would go back to the system, to come again page by page.
    mallopt(M_TRIM_THRESHOLD, 32 << 20);
#endif
}

} // namespace wm3d::cmd

// Sanitizers have operators of their own.
#if defined(__GLIBC__) && defined(MADV_HUGEPAGE) && !defined(WM3D_SANITIZED)

namespace {

/// A block in large pages where the system has them: a sixth of the time of a dense model's mark went into giving it
/// memory by pages of 4 kB. The rest of a page at the end stays small, so that no more memory is taken.
void* allocate(std::size_t size) {
    if (size < wm3d::cmd::large)
        return std::malloc(std::max<std::size_t>(size, 1));
    void* block = std::aligned_alloc(wm3d::cmd::large, size);
    if (block)
        madvise(block, size / wm3d::cmd::large * wm3d::cmd::large, MADV_HUGEPAGE);
    return block;
}

} // namespace

void* operator new(std::size_t size) {
    for (;;) {
        if (void* block = allocate(size))
            return block;
        const std::new_handler make_room = std::get_new_handler();
        if (!make_room)
            throw std::bad_alloc();
        make_room();
    }
}

void operator delete(void* block) noexcept {
    std::free(block);
}

void operator delete(void* block, std::size_t) noexcept {
    std::free(block);
}

#endif
