// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/mesh/umbrella.hpp>

#include <wm3d/core/parallel.hpp>

namespace wm3d {

namespace {

constexpr std::size_t umbrella_block = 8192;

/// Applies `step(from, v)` to every vertex, `steps` times.
template<typename Step>
std::vector<Vec3> repeat(std::vector<Vec3> x, int steps, const Step& step) {
    std::vector<Vec3> previous(x.size());
    for (int i = 0; i < steps; ++i) {
        previous.swap(x);
        parallel_blocks(x.size(), umbrella_block, [&](std::size_t begin, std::size_t end) {
            for (std::size_t v = begin; v < end; ++v)
                x[v] = step(previous, v);
        });
    }
    return x;
}

} // namespace

std::vector<Vec3> Umbrella::smooth(std::vector<Vec3> x, int steps, double weight) const {
    return repeat(std::move(x), steps, [&](const std::vector<Vec3>& from, std::size_t v) -> Vec3 {
        if (stays(v))
            return from[v];
        Vec3 sum = Vec3::Zero();
        for (Index w : neighbours_.of(v))
            sum += from[w];
        return from[v] + weight * (sum * share(v) - from[v]);
    });
}

std::vector<Vec3> Umbrella::smooth_transposed(std::vector<Vec3> x, int steps, double weight) const {
    return repeat(std::move(x), steps, [&](const std::vector<Vec3>& from, std::size_t v) -> Vec3 {
        Vec3 sum = stays(v) ? from[v] : Vec3((1 - weight) * from[v]);
        for (Index w : neighbours_.of(v))
            if (!stays(w))
                sum += weight * share(w) * from[w];
        return sum;
    });
}

} // namespace wm3d
