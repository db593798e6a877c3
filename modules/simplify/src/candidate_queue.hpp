// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The vertices in the order in which their removal costs least.
#pragma once

#include <algorithm>
#include <array>
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
    explicit CandidateQueue(const std::vector<Candidate>& entries) : size_(entries.size()) {
        lines_.reserve((entries.size() + entries.size() / 16) / ways + 2);
        lines_.resize(entries.size() / ways + 2);
        for (std::size_t i = 0; i < size_; ++i)
            at(i) = entries[i];
        for (std::size_t i = (size_ + ways - 2) / ways; i-- > 0;)
            sink(i, at(i));
    }

    bool empty() const { return size_ == 0; }
    Candidate top() const { return lines_.front()[ways - 1]; }

    void push(Candidate c) {
        std::size_t i = size_++;
        if (i / ways + 1 == lines_.size())
            lines_.emplace_back();
        for (; i > 0 && c < at((i - 1) / ways); i = (i - 1) / ways)
            at(i) = at((i - 1) / ways);
        at(i) = c;
    }

    void pop() {
        const Candidate last = std::exchange(at(--size_), nothing);
        if (size_ > 0)
            sink(0, last);
    }

    /// pop and push in one; `c` is not less than the top.
    void replace_top(Candidate c) { sink(0, c); }

    /// The one that came right below the top last, or the top: of those that will soon be there.
    Candidate approaching() const {
        const Candidate child = lines_[1][refilled_];
        return child == nothing ? top() : child;
    }

private:
    static constexpr std::size_t ways = 8;
    static constexpr Candidate nothing = ~Candidate{0}; ///< so that every parent has eight children

    /// The children of entry i are line i + 1, and the top is alone on the first.
    struct alignas(ways * sizeof(Candidate)) Line {
        std::array<Candidate, ways> entries;
        Line() { entries.fill(nothing); }
        Candidate& operator[](std::size_t k) { return entries[k]; }
        Candidate operator[](std::size_t k) const { return entries[k]; }
    };

    Candidate& at(std::size_t i) { return lines_[(i + ways - 1) / ways][(i + ways - 1) % ways]; }

    struct Child {
        Candidate candidate;
        std::uint64_t number;
    };

    /// Without branches: which child is least is as good as random.
    static Child lesser(const Child& a, const Child& b) {
        const std::uint64_t less = std::uint64_t{0} - (b.candidate < a.candidate); // all bits or none
        return {a.candidate ^ ((a.candidate ^ b.candidate) & less),
                a.number ^ ((a.number ^ b.number) & less)};
    }

    static Child least(const Line& l) {
        return lesser(lesser(lesser({l[0], 0}, {l[1], 1}), lesser({l[2], 2}, {l[3], 3})),
                      lesser(lesser({l[4], 4}, {l[5], 5}), lesser({l[6], 6}, {l[7], 7})));
    }

    /// Puts c at place i or below.
    void sink(std::size_t i, Candidate c) {
        while (ways * i + 1 < size_) {
            const Child child = least(lines_[i + 1]);
            if (c <= child.candidate)
                break;
            at(i) = child.candidate;
            if (i == 0)
                refilled_ = child.number;
            i = ways * i + 1 + child.number;
        }
        at(i) = c;
    }

    std::vector<Line> lines_;
    std::size_t size_;
    std::size_t refilled_ = 0; ///< the top's child whose place was taken anew last
};

} // namespace wm3d::simplify
