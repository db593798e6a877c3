// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/core/memory.hpp>

#include <fstream>
#include <memory>
#include <vector>

#include <doctest/doctest.h>

using namespace wm3d;

namespace {

// Sanitizers bring an allocator of their own, which gives back what it likes.
#if defined(__has_feature)
#define WM3D_HAS_FEATURE(feature) __has_feature(feature)
#else
#define WM3D_HAS_FEATURE(feature) 0
#endif
#if defined(__SANITIZE_ADDRESS__) || defined(__SANITIZE_THREAD__) || WM3D_HAS_FEATURE(address_sanitizer) ||  \
    WM3D_HAS_FEATURE(thread_sanitizer)
constexpr bool systems_allocator = false;
#else
constexpr bool systems_allocator = true;
#endif

/// Pages that this process holds; 0 where the system doesn't say.
std::size_t resident_pages() {
    std::size_t all = 0, resident = 0;
    std::ifstream("/proc/self/statm") >> all >> resident;
    return resident;
}

} // namespace

TEST_CASE("memory of small blocks that were freed goes back to the system") {
    if (!systems_allocator) {
        MESSAGE("SKIPPED: a sanitizer's allocator holds what was freed");
        return;
    }
    constexpr std::size_t count = 20000, size = 1000;
    std::vector<std::unique_ptr<char[]>> blocks;
    for (std::size_t i = 0; i < count; ++i)
        blocks.push_back(std::make_unique<char[]>(size)); // written: with zeros
    const auto last = std::make_unique<char[]>(size);     // so that they don't lie at the end
    const std::size_t before = resident_pages();
    blocks.clear();
    return_freed_memory();
    if (before == 0) {
        MESSAGE("SKIPPED: the system doesn't say how much memory is held");
        return;
    }
    CHECK(resident_pages() + count * size / 4096 / 2 < before);
}
