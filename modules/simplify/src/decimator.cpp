// SPDX-License-Identifier: GPL-3.0-or-later
#include "decimator.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <numbers>

namespace wm3d::simplify {

namespace {

constexpr std::size_t report_every = 8192;

/// Whether one of the triangles of a ring's centre has the corners a and b besides.
bool has_triangle(Ring ring, Index a, Index b) {
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const Index one = ring[i].vertex, other = ring[i + 1 == ring.size() ? 0 : i + 1].vertex;
        if (ring[i].corner != no_index && ((one == a && other == b) || (one == b && other == a)))
            return true;
    }
    return false;
}

} // namespace

Decimator::Decimator(Rings& rings, Sites& sites, const Options& options, Observer* observer)
    : rings_(rings), sites_(sites), observer_(observer), keys_(sites.key), queue_(initial_candidates(keys_)) {
    const double cosine = std::cos(options.max_normal_turn / 180 * std::numbers::pi);
    least_cosine2_ = cosine * cosine;
}

std::vector<Candidate> Decimator::initial_candidates(const std::vector<CostKey>& keys) {
    std::vector<Candidate> candidates;
    candidates.reserve(keys.size());
    for (Index v = 0; v < keys.size(); ++v)
        if (keys[v] != no_cost)
            candidates.push_back(candidate(keys[v], v));
    return candidates;
}

std::size_t Decimator::remove(std::size_t count, const Progress& progress) {
    std::size_t removed = 0;
    while (removed < count && !queue_.empty()) {
        const Candidate top = queue_.top();
        if (is_out_of_date(top)) { // since the last collapse
            advance();
            continue;
        }
        if (!settle(vertex_of(top), key_of(top)))
            continue;
        if (++removed % report_every == 0)
            notify(progress, "simplify", static_cast<double>(removed) / static_cast<double>(count));
    }
    return removed;
}

/// Collapses v, whose entry is the top of the queue, if a choice at this key is sound; if not, v gets the key
/// of its next choice.
bool Decimator::settle(Index v, CostKey key) {
    list_choices(v);
    for (auto rest = choices_.begin(); rest != choices_.end(); ++rest) {
        std::iter_swap(rest, std::min_element(rest, choices_.end())); // seldom more than one is looked at
        if (rest->key > key) {
            keys_[v] = rest->key;
            advance(candidate(rest->key, v));
            return false;
        }
        if (keeps_topology(v, rest->place) && keeps_normals(v, rest->place)) {
            advance();
            collapse(v, rest->place);
            return true;
        }
    }
    keys_[v] = no_cost; // until its surroundings change
    advance();
    return false;
}

/// Takes the top off the queue, or puts `instead` in its place. What the next vertices need lies anywhere in memory: asked
/// for now, it is there when their turn comes.
void Decimator::advance(std::optional<Candidate> instead) {
    if (instead)
        queue_.replace_top(*instead);
    else
        queue_.pop();
    while (!queue_.empty() && is_out_of_date(queue_.top()))
        queue_.pop();
    if (queue_.empty())
        return;
    const Ring next = rings_.of(vertex_of(queue_.top()));
    for (std::size_t i = 0; i <= next.size(); ++i) {
        const Index v = i < next.size() ? next[i].vertex : vertex_of(queue_.approaching());
        for (const void* place : rings_.places(v)) // here: g++ leaves out calls of what does nothing else
            __builtin_prefetch(place, 1);
        for (const void* place : sites_.places(v))
            __builtin_prefetch(place, 1);
    }
}

void Decimator::list_choices(Index v) {
    choices_.clear();
    const Ring ring = rings_.of(v);
    const std::size_t last = ring.size() - 1;
    for (std::size_t i = 0; i <= last; i += is_closed(ring) ? 1 : last)
        choices_.push_back({cost_key(cost(v, ring[i].vertex)), ring[i].vertex, i});
}

/// The link condition: the only vertices next to both ends of the edge are those of its triangles, and no
/// part is flattened into two faces or lost.
bool Decimator::keeps_topology(Index v, std::size_t place) const {
    const Ring ring = rings_.of(v), around = rings_.of(ring[place].vertex);
    const std::size_t size = ring.size();
    const bool closed = is_closed(ring);
    const std::size_t after = closed && place + 1 == size ? 0 : place + 1;
    const std::size_t before = place > 0 ? place - 1 : closed ? size - 1 : size;
    if (closed ? size == 3 && has_triangle(around, ring[after].vertex, ring[before].vertex)
               : size == 2 && around.size() == 2)
        return false; // a tetrahedron, perhaps slit along an edge; a lone triangle
    for (std::size_t i = 0; i < size; ++i) {
        if (i == after || i == before)
            continue;
        for (const Spoke& s : around)
            if (s.vertex == ring[i].vertex)
                return false;
    }
    return true;
}

/// No surviving triangle turns too far.
bool Decimator::keeps_normals(Index v, std::size_t place) const {
    const Ring ring = rings_.of(v);
    const Vec3& from = sites_.site[v].position;
    const Vec3& to = sites_.site[ring[place].vertex].position;
    for (std::size_t i = 0; i < ring.size(); ++i) {
        const std::size_t j = i + 1 == ring.size() ? 0 : i + 1;
        if (i == place || j == place || ring[i].corner == no_index)
            continue; // vanishes
        const Vec3& a = sites_.site[ring[i].vertex].position;
        const Vec3& b = sites_.site[ring[j].vertex].position;
        const Vec3 old_normal = (a - from).cross(b - from), new_normal = (a - to).cross(b - to);
        const double old2 = old_normal.squaredNorm(), dot = old_normal.dot(new_normal);
        if (old2 > 0 && (dot <= 0 || dot * dot < least_cosine2_ * old2 * new_normal.squaredNorm()))
            return false;
    }
    return true;
}

void Decimator::collapse(Index v, std::size_t place) {
    if (observer_)
        tell_observer(v, place);
    const Index kept = rings_.of(v)[place].vertex;
    const double total = cost(v, kept);
    Quadric& quadric = sites_.quadric[kept];
    quadric.merge(sites_.quadric[v], offset(v, kept));
    sites_.site[kept].constant = total;
    if (const double weight = quadric.trace(); weight > 0)
        largest_error_ = std::max(largest_error_, total / weight);

    const Ring ring = rings_.of(v);
    ring_.assign(ring.begin(), ring.end());
    rings_.collapse(v, place);
    keys_[v] = no_cost;
    reconsider(kept);
}

void Decimator::tell_observer(Index v, std::size_t place) {
    const Ring ring = rings_.of(v);
    Collapse step{v, ring[place].vertex, ring, place, no_index};
    if (!step.closed() && ring.size() == 2)
        for (const Spoke& s : rings_.of(ring[1].vertex))
            if (s.vertex == ring[0].vertex)
                step.beyond = s.corner;
    observer_->collapse(step);
}

/// After a collapse to `kept`: its own costs are new; of the costs of its neighbours only those along new
/// edges may have fallen, and a neighbour that was stuck gets another chance.
void Decimator::reconsider(Index kept) {
    for (const Spoke& s : ring_)
        if (s.vertex != kept && (sites_.kind[s.vertex] == Kind::interior ||
                                 sites_.kind[kept] != Kind::interior || keys_[s.vertex] == no_cost))
            lower_key(s.vertex, cost(s.vertex, kept));
    if (sites_.kind[kept] == Kind::locked)
        return;
    double least = std::numeric_limits<double>::max();
    const double constant = sites_.site[kept].constant;
    const Quadric quadric = sites_.quadric[kept];
    for (const Spoke& s : rings_.of(kept))
        least = std::min(least, constant + quadric.evaluate(offset(kept, s.vertex)) +
                                    sites_.site[s.vertex].constant);
    keys_[kept] = cost_key(least);
    queue_.push(candidate(keys_[kept], kept));
}

void Decimator::lower_key(Index v, double cost) {
    const CostKey key = cost_key(cost);
    if (key >= keys_[v] || sites_.kind[v] == Kind::locked)
        return;
    keys_[v] = key;
    queue_.push(candidate(key, v));
}

} // namespace wm3d::simplify
