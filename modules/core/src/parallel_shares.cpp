// SPDX-License-Identifier: GPL-3.0-or-later
// What is made of the other loops, whatever threads run them.
#include <algorithm>

#include <wm3d/core/parallel.hpp>

namespace wm3d {

void parallel_shares(std::size_t count, std::size_t length,
                     const std::function<void(std::size_t, std::size_t)>& body) {
    constexpr std::size_t long_list = 1 << 20;
    constexpr std::size_t most = 8; // more would wait for memory
    const std::size_t shares = length < long_list ? 1 : std::clamp<std::size_t>(thread_count(), 1, most);
    if (count > 0)
        parallel_blocks(count, (count + shares - 1) / shares, body);
}

} // namespace wm3d
