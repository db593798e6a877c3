// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Random order.
#pragma once

#include <numeric>
#include <utility>
#include <vector>

#include <wm3d/attack/random.hpp>
#include <wm3d/mesh/types.hpp>

namespace wm3d::attack {

/// The numbers 0 to count - 1 in random order (Fisher and Yates).
inline std::vector<Index> random_permutation(std::size_t count, const RandomStream& random) {
    std::vector<Index> order(count);
    std::iota(order.begin(), order.end(), Index{0});
    for (std::size_t left = count; left > 1; --left)
        std::swap(order[left - 1], order[random.below(left, left)]);
    return order;
}

} // namespace wm3d::attack
