// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The vertices in the order in which their removal costs least.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>
#include <vector>

#include <wm3d/mesh/types.hpp>

namespace wm3d::simplify {

/// A cost as an integer of the same order: the bits of a float that isn't negative. Costs are compared at 24
/// bits; what is then equal is decided by the number of the vertex, so by its place on the curve.
using CostKey = std::uint32_t;
inline constexpr CostKey no_cost = 0xffffffffu;

inline CostKey cost_key(double cost) {
    return std::bit_cast<CostKey>(static_cast<float>(std::max(cost, 0.0)));
}

/// One candidate: its cost above, its vertex below, so that comparing numbers compares costs.
using Candidate = std::uint64_t;

inline Candidate candidate(CostKey key, Index vertex) {
    return (static_cast<Candidate>(key) << 32) | vertex;
}
inline CostKey key_of(Candidate c) {
    return static_cast<CostKey>(c >> 32);
}
inline Index vertex_of(Candidate c) {
    return static_cast<Index>(c);
}

/// An eight-way min-heap: one cache line of children per level. Entries are never changed in place; the owner
/// recognises those out of date by their cost.
class CandidateQueue {
public:
    explicit CandidateQueue(std::vector<Candidate> entries) : heap_(std::move(entries)), size_(heap_.size()) {
        heap_.resize(size_ + ways, nothing);
        for (std::size_t i = (size_ + ways - 2) / ways; i-- > 0;)
            sink(i, heap_[i]);
    }

    bool empty() const { return size_ == 0; }
    Candidate top() const { return heap_.front(); }

    void push(Candidate c) {
        std::size_t i = size_++;
        if (heap_.size() < size_ + ways)
            heap_.push_back(nothing);
        for (; i > 0 && c < heap_[(i - 1) / ways]; i = (i - 1) / ways)
            heap_[i] = heap_[(i - 1) / ways];
        heap_[i] = c;
    }

    void pop() {
        const Candidate last = std::exchange(heap_[--size_], nothing);
        if (size_ > 0)
            sink(0, last);
    }

    /// pop and push in one; `c` is not less than the top.
    void replace_top(Candidate c) { sink(0, c); }

private:
    static constexpr std::size_t ways = 8;
    static constexpr Candidate nothing =
        ~Candidate{0}; ///< fills the last line, so that every parent has eight children

    /// Puts c at place i or below.
    void sink(std::size_t i, Candidate c) {
        for (std::size_t first = ways * i + 1; first < size_; first = ways * i + 1) {
            // without branches: which child is least is as good as random
            Candidate least = heap_[first];
            std::size_t place = first;
            for (std::size_t k = first + 1; k < first + ways; ++k) {
                const std::uint64_t less = std::uint64_t{0} - (heap_[k] < least); // all bits or none
                place ^= (place ^ k) & less;
                least ^= (least ^ heap_[k]) & less;
            }
            if (c <= least)
                break;
            heap_[i] = least;
            i = place;
        }
        heap_[i] = c;
    }

    std::vector<Candidate> heap_; ///< and at least `ways` times `nothing`
    std::size_t size_;
};

} // namespace wm3d::simplify
