// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The surface while it is simplified: around each vertex, its neighbours in order.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <wm3d/simplify/observer.hpp>

namespace wm3d::simplify {

/// A ring of neighbours, counter-clockwise. Spoke i leads to a neighbour and names the corner, at the centre,
/// of the triangle (centre, neighbour i, neighbour i + 1). The last spoke of an open ring has no triangle.
using Ring = std::span<const Spoke>;

inline bool is_closed(Ring ring) {
    return ring.back().corner != no_index;
}

/// All rings, each one piece of memory, so that looking around a vertex costs one jump and not one per
/// triangle.
class Rings {
public:
    /// Rings of the given sizes, to be filled through `ring`.
    explicit Rings(const std::vector<Index>& sizes);

    std::size_t size() const { return block_.size(); }
    Ring of(Index v) const { return {pool_.data() + block_[v].begin, block_[v].size}; }
    bool alive(Index v) const { return block_[v].size > 0; }

    /// Half-edge collapse of v to its neighbour number `place`.
    /// \pre  the link condition holds and a triangle is left
    void collapse(Index v, std::size_t place);

    std::span<Spoke> ring(Index v) { return {pool_.data() + block_[v].begin, block_[v].size}; }

private:
    struct Block {
        Index begin = 0;
        Index size = 0;
        Index capacity = 0;
    };

    std::size_t find(Index v, Index neighbour) const;
    void erase(Index v, std::size_t at);
    void join(Index kept, Index removed, std::size_t place);
    void assign(Index v, Ring spokes);
    void release(Block& block);
    Block allocate(std::size_t size);

    std::vector<Spoke> pool_;
    std::vector<Block> block_;                ///< #W
    std::array<std::vector<Index>, 32> free_; ///< by logarithm of capacity: beginnings of blocks no one uses
    std::vector<Spoke> removed_, joined_;     ///< kept between calls to save allocations
};

} // namespace wm3d::simplify
