// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The greedy loop of half-edge collapses.
#pragma once

#include <optional>
#include <vector>

#include <wm3d/core/progress.hpp>
#include <wm3d/simplify/observer.hpp>
#include <wm3d/simplify/simplify.hpp>

#include "candidate_queue.hpp"
#include "rings.hpp"
#include "sites.hpp"

namespace wm3d::simplify {

/// Removes vertices in the order of least quadric error. The key of a vertex in the queue never exceeds its
/// true cost: merging quadrics only raises costs, and the one way to a lower cost, a new edge, is looked at
/// when it appears. So a cost is computed anew only when its vertex comes to the top.
class Decimator {
public:
    /// \pre  `observer` may be null
    Decimator(Rings& rings, Sites& sites, const Options& options, Observer* observer);

    /// Removes `count` vertices, or as many as can go. Returns the number removed.
    std::size_t remove(std::size_t count, const Progress& progress);

    /// Largest mean squared distance met so far.
    double largest_error() const { return largest_error_; }

private:
    /// A neighbour the vertex in hand could collapse to.
    struct Choice {
        CostKey key;
        Index vertex;
        std::size_t place; ///< in the ring
        bool operator<(const Choice& o) const { return key != o.key ? key < o.key : vertex < o.vertex; }
    };

    static std::vector<Candidate> initial_candidates(const std::vector<CostKey>& keys);
    bool settle(Index v, CostKey key);
    bool is_out_of_date(Candidate c) const { return keys_[vertex_of(c)] != key_of(c); }
    void advance(std::optional<Candidate> instead = {});
    void list_choices(Index v);
    bool keeps_topology(Index v, std::size_t place) const;
    bool keeps_normals(Index v, std::size_t place) const;
    void collapse(Index v, std::size_t place);
    void tell_observer(Index v, std::size_t place);
    void reconsider(Index kept);
    void lower_key(Index v, double cost);

    Vec3 offset(Index from, Index to) const { return sites_.site[to].position - sites_.site[from].position; }
    double cost(Index removed, Index kept) const {
        return sites_.site[removed].constant + sites_.quadric[removed].evaluate(offset(removed, kept)) +
               sites_.site[kept].constant;
    }

    Rings& rings_;
    Sites& sites_;
    Observer* observer_;
    double least_cosine2_ = 0;   ///< square of the cosine of the largest turn of a normal
    std::vector<CostKey>& keys_; ///< of each vertex's live entry in the queue; no_cost: none
    CandidateQueue queue_;
    double largest_error_ = 0;
    std::vector<Spoke> ring_;     ///< of the vertex just removed
    std::vector<Choice> choices_; ///< of the vertex in hand; kept between calls to save allocations
};

} // namespace wm3d::simplify
