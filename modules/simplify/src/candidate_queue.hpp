// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The vertices in the order in which their removal costs least.
#pragma once

#include <algorithm>
#include <bit>
#include <cstdint>
#include <vector>

#include <wm3d/mesh/types.hpp>

namespace wm3d::simplify {

/// A cost as an integer of the same order: the bits of a float that isn't negative. Costs are compared at 24
/// bits; what is then equal is decided by the number of the vertex, so by its place on the curve.
using CostKey = std::uint32_t;
inline constexpr CostKey no_cost = 0xffffffffu;

inline CostKey cost_key(double cost) { return std::bit_cast<CostKey>(static_cast<float>(std::max(cost, 0.0))); }

/// One candidate: its cost above, its vertex below, so that comparing numbers compares costs.
using Candidate = std::uint64_t;

inline Candidate candidate(CostKey key, Index vertex) { return (static_cast<Candidate>(key) << 32) | vertex; }
inline CostKey key_of(Candidate c) { return static_cast<CostKey>(c >> 32); }
inline Index vertex_of(Candidate c) { return static_cast<Index>(c); }

/// An eight-way min-heap: one cache line of children per level. Entries are never changed in place; the owner
/// recognises those out of date by their cost.
class CandidateQueue {
public:
    explicit CandidateQueue(std::vector<Candidate> entries) : heap_(std::move(entries)) {
        for (std::size_t i = (heap_.size() + ways - 2) / ways; i-- > 0;)
            sink(i);
    }

    bool empty() const { return heap_.empty(); }
    Candidate top() const { return heap_.front(); }

    void push(Candidate c) {
        std::size_t i = heap_.size();
        heap_.push_back(c);
        for (; i > 0 && c < heap_[(i - 1) / ways]; i = (i - 1) / ways)
            heap_[i] = heap_[(i - 1) / ways];
        heap_[i] = c;
    }

    void pop() {
        heap_.front() = heap_.back();
        heap_.pop_back();
        if (!heap_.empty())
            sink(0);
    }

    /// pop and push in one; `c` is not less than the top.
    void replace_top(Candidate c) {
        heap_.front() = c;
        sink(0);
    }

private:
    static constexpr std::size_t ways = 8;

    void sink(std::size_t i) {
        const Candidate c = heap_[i];
        for (;;) {
            const std::size_t first = ways * i + 1;
            if (first >= heap_.size())
                break;
            const std::size_t last = std::min(first + ways, heap_.size());
            std::size_t least = first;
            for (std::size_t k = first + 1; k < last; ++k)
                least = heap_[k] < heap_[least] ? k : least;
            if (c <= heap_[least])
                break;
            heap_[i] = heap_[least];
            i = least;
        }
        heap_[i] = c;
    }

    std::vector<Candidate> heap_;
};

} // namespace wm3d::simplify
