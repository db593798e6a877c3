// SPDX-License-Identifier: GPL-3.0-or-later
#include "rings.hpp"

#include <algorithm>
#include <bit>

namespace wm3d::simplify {

Index Rings::capacity_for(std::size_t size) {
    return static_cast<Index>(std::max(home, std::bit_ceil(size)));
}

Rings::Rings(std::size_t vertices) : block_(vertices) {
    pool_.reserve(home * (vertices + vertices / 16));
    pool_.resize(home * vertices);
    for (std::size_t v = 0; v < vertices; ++v)
        block_[v] = {static_cast<Index>(home * v), 0, home};
}

void Rings::append(Index v, const Spoke& spoke) {
    if (Block& own = block_[v]; own.size == own.capacity) {
        const Block larger = allocate(own.size + 1);
        std::copy_n(pool_.begin() + own.begin, own.size, pool_.begin() + larger.begin);
        const Index size = own.size;
        release(own);
        own = {larger.begin, size, larger.capacity};
    }
    pool_[block_[v].begin + block_[v].size++] = spoke;
}

void Rings::collapse(Index v, std::size_t place) {
    const Ring own = of(v);
    removed_.assign(own.begin(), own.end());
    const std::size_t size = removed_.size();
    const bool closed = is_closed(removed_);
    const Index kept = removed_[place].vertex;
    const std::size_t after = closed && place + 1 == size ? 0 : place + 1;
    const std::size_t before = place > 0 ? place - 1 : closed ? size - 1 : size;
    for (std::size_t i = 0; i < size; ++i) {
        const Index w = removed_[i].vertex;
        if (i == place)
            continue;
        const std::size_t at = find(w, v);
        const std::span<Spoke> around = ring(w);
        if (i == before) // the triangle after v now comes after the kept vertex, which stands before v
            around[at > 0 ? at - 1 : around.size() - 1].corner = around[at].corner;
        if (i == before || i == after)
            erase(w, at);
        else
            around[at].vertex = kept;
    }
    join(kept, v, place);
    release(block_[v]);
}

/// Puts the triangles of the removed vertex that survive into the ring of the kept one. Counter-clockwise
/// around `kept` come the neighbour after it in the ring of `removed`, then `removed`, then the neighbour
/// before it.
void Rings::join(Index kept, Index removed, std::size_t place) {
    const Ring ring = of(kept);
    const std::size_t at = find(kept, removed), size = ring.size(), count = removed_.size();
    joined_.clear();
    const auto add = [&](Ring from, std::size_t begin, std::size_t end) {
        joined_.insert(joined_.end(), from.begin() + static_cast<std::ptrdiff_t>(begin),
                       from.begin() + static_cast<std::ptrdiff_t>(std::max(begin, end)));
    };
    const bool ring_closed = is_closed(ring);
    if (!ring_closed && at > 0)
        add(ring, 0, at - 1);
    if (!is_closed(removed_)) {
        add(removed_, place == 0 ? 1 : 0, place == 0 ? count : count - 2);
    } else { // all but the kept vertex and the one before it
        for (std::size_t i = 1; i + 1 < count; ++i)
            joined_.push_back(removed_[(place + i) % count]);
    }
    if (!ring_closed)
        add(ring, at + 1, size);
    else
        for (std::size_t i = 1; i + 1 < size; ++i)
            joined_.push_back(ring[(at + i) % size]);
    assign(kept, joined_);
}

std::size_t Rings::find(Index v, Index neighbour) const {
    const Ring ring = of(v);
    std::size_t i = 0;
    while (ring[i].vertex != neighbour)
        ++i;
    return i;
}

void Rings::erase(Index v, std::size_t at) {
    const std::span<Spoke> spokes = ring(v);
    std::copy(spokes.begin() + static_cast<std::ptrdiff_t>(at) + 1, spokes.end(),
              spokes.begin() + static_cast<std::ptrdiff_t>(at));
    --block_[v].size;
}

void Rings::assign(Index v, Ring spokes) {
    Block& b = block_[v];
    if (b.capacity < spokes.size()) {
        release(b);
        b = allocate(spokes.size());
    }
    std::copy(spokes.begin(), spokes.end(), pool_.begin() + b.begin);
    b.size = static_cast<Index>(spokes.size());
}

void Rings::release(Block& b) {
    free_[static_cast<std::size_t>(std::countr_zero(b.capacity))].push_back(b.begin);
    b = {};
}

Rings::Block Rings::allocate(std::size_t size) {
    const Index capacity = capacity_for(size);
    std::vector<Index>& free = free_[static_cast<std::size_t>(std::countr_zero(capacity))];
    Block b{0, 0, capacity};
    if (free.empty()) {
        b.begin = static_cast<Index>(pool_.size());
        pool_.resize(pool_.size() + capacity);
    } else {
        b.begin = free.back();
        free.pop_back();
    }
    return b;
}

} // namespace wm3d::simplify
