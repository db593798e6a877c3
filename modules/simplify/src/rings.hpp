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
/// triangle. A ring has a home, a cache line whose place its vertex tells, and leaves it when it gets too large.
class Rings {
public:
    /// Empty rings.
    explicit Rings(std::size_t vertices);

    std::size_t size() const { return block_.size(); }
    Ring of(Index v) const { return {pool_.data() + block_[v].begin, block_[v].size}; }
    bool alive(Index v) const { return block_[v].size > 0; }

    /// Puts a spoke at the end of the ring of v.
    void append(Index v, const Spoke& spoke);

    /// Where the size and, most often, the spokes of the ring of v lie.
    std::array<const void*, 2> places(Index v) const { return {&block_[v], pool_.data() + home * v}; }

    /// Half-edge collapse of v to its neighbour number `place`.
    /// \pre  the link condition holds and a triangle is left
    void collapse(Index v, std::size_t place);

    std::span<Spoke> ring(Index v) { return {pool_.data() + block_[v].begin, block_[v].size}; }

private:
    static constexpr std::size_t home = 8; ///< spokes: a cache line

    struct Block {
        Index begin = 0;
        Index size = 0;
        Index capacity = 0;
    };

    std::size_t find(Index v, Index neighbour) const;
    void erase(Index v, std::size_t at);
    void join(Index kept, Index removed, std::size_t place);
    void assign(Index v, Ring spokes);
    static Index capacity_for(std::size_t size);
    void release(Block& block);
    Block allocate(std::size_t size);

    std::vector<Spoke> pool_;
    std::vector<Block> block_;                ///< #W
    std::array<std::vector<Index>, 32> free_; ///< by logarithm of capacity: beginnings of blocks no one uses
    std::vector<Spoke> removed_, joined_;     ///< kept between calls to save allocations
};

} // namespace wm3d::simplify
