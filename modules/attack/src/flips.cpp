// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/attack/flips.hpp>

#include <algorithm>
#include <cmath>
#include <deque>

#include <wm3d/attack/random.hpp>

#include "flipper.hpp"
#include "permutation.hpp"

namespace wm3d::attack {

Flipped flip_random(const TriangleMesh& mesh, double percent, std::uint64_t seed,
                    const FlipOptions& options) {
    Flipper flipper(mesh, options.max_angle);
    const std::vector<Index> starts = flipper.inner_edges();
    const auto wanted =
        static_cast<std::size_t>(std::llround(percent / 100 * static_cast<double>(flipper.edge_count())));
    std::size_t flips = 0;
    // A flip re-uses the half-edge slots of its two triangles; a slot that is visited names the edge it holds
    // then.
    for (Index i : random_permutation(starts.size(), RandomStream(seed, 0))) {
        if (flips == wanted)
            break;
        if (flipper.may_flip(starts[i])) {
            flipper.flip(starts[i]);
            ++flips;
        }
    }
    return {std::move(flipper).mesh(), flips};
}

Flipped flip_delaunay(const TriangleMesh& mesh, const FlipOptions& options) {
    Flipper flipper(mesh, options.max_angle);
    const std::vector<Index> starts = flipper.inner_edges();
    std::deque<Index> queue(starts.begin(), starts.end());
    const std::size_t most = 10 * flipper.edge_count();
    std::size_t flips = 0;
    while (!queue.empty() && flips < most) {
        const Index edge = queue.front();
        queue.pop_front();
        if (flipper.is_delaunay(edge) || !flipper.may_flip(edge))
            continue;
        for (Index changed : flipper.flip(edge))
            queue.push_back(changed);
        ++flips;
    }
    return {std::move(flipper).mesh(), flips};
}

} // namespace wm3d::attack
