// SPDX-License-Identifier: GPL-3.0-or-later
#include "decimator.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <wm3d/mesh/parallel.hpp>

namespace wm3d::simplify {

namespace {

constexpr std::size_t block = 4096;
constexpr std::size_t report_every = 8192;

} // namespace

Decimator::Decimator(HalfEdges& mesh, Sites& sites, const Options& options, Observer* observer)
    : mesh_(mesh), sites_(sites), observer_(observer), queue_(initial_candidates(mesh, sites, keys_)) {
    const double cosine = std::cos(options.max_normal_turn / 180 * std::numbers::pi);
    least_cosine2_ = cosine * cosine;
}

std::vector<Candidate> Decimator::initial_candidates(const HalfEdges& mesh, const Sites& sites,
                                                     std::vector<CostKey>& keys) {
    const std::size_t count = mesh.leaving.size();
    keys.assign(count, no_cost);
    parallel_blocks(count, block, [&](std::size_t begin, std::size_t end) {
        for (auto v = static_cast<Index>(begin); v < end; ++v) {
            if (sites.kind[v] == Kind::locked)
                continue;
            // a lower bound for boundary vertices, whose choices are fewer
            const Index start = mesh.leaving[v];
            double least = std::numeric_limits<double>::max();
            const auto consider = [&](Index w) {
                least = std::min(least, sites.quadric[v].evaluate(sites.site[w].position - sites.site[v].position));
            };
            Index h = start, last = h;
            do {
                consider(mesh.target(h));
                last = h;
                h = mesh.turn(h);
            } while (h != start && h != no_index);
            if (h == no_index)
                consider(mesh.edges[previous(last)].origin);
            keys[v] = cost_key(least);
        }
    });
    std::vector<Candidate> candidates;
    candidates.reserve(count + count / 2);
    for (Index v = 0; v < count; ++v)
        if (keys[v] != no_cost)
            candidates.push_back(candidate(keys[v], v));
    return candidates;
}

std::size_t Decimator::remove(std::size_t count, const Progress& progress) {
    std::size_t removed = 0;
    while (removed < count && !queue_.empty()) {
        const Candidate top = queue_.top();
        if (keys_[vertex_of(top)] != key_of(top)) { // out of date
            queue_.pop();
            continue;
        }
        if (!settle(vertex_of(top), key_of(top)))
            continue;
        if (++removed % report_every == 0)
            report(progress, "simplify", static_cast<double>(removed) / static_cast<double>(count));
    }
    return removed;
}

/// Collapses v, whose entry is the top of the queue, if a choice at this key is sound; if not, v gets the key of
/// its next choice.
bool Decimator::settle(Index v, CostKey key) {
    gather(v);
    list_choices(v);
    for (const Choice& choice : choices_) {
        if (choice.key > key) {
            keys_[v] = choice.key;
            queue_.replace_top(candidate(choice.key, v));
            return false;
        }
        if (keeps_topology(choice.place) && keeps_normals(v, choice.place)) {
            queue_.pop();
            collapse(v, choice.place);
            return true;
        }
    }
    keys_[v] = no_cost; // until its surroundings change
    queue_.pop();
    return false;
}

/// Fills ring_ and spokes_ with the fan of v.
void Decimator::gather(Index v) {
    ring_.clear();
    spokes_.clear();
    const Index start = mesh_.leaving[v];
    Index h = start;
    do {
        spokes_.push_back(h);
        ring_.push_back(mesh_.target(h));
        h = mesh_.turn(h);
    } while (h != start && h != no_index);
    closed_ = h == start;
    if (!closed_)
        ring_.push_back(mesh_.edges[previous(spokes_.back())].origin);
}

/// Fills choices_, cheapest first, places deciding between equals.
void Decimator::list_choices(Index v) {
    choices_.clear();
    const auto last = static_cast<Index>(ring_.size() - 1);
    for (Index i = 0; i <= last; i += closed_ ? 1 : last)
        choices_.push_back({cost_key(cost(v, ring_[i])), i});
    std::sort(choices_.begin(), choices_.end(), [&](const Choice& a, const Choice& b) {
        return a.key != b.key ? a.key < b.key : ring_[a.place] < ring_[b.place];
    });
}

/// The link condition: the only vertices next to both ends of the edge are those of its triangles, and no
/// component is flattened into two faces or lost.
bool Decimator::keeps_topology(Index kept_place) const {
    const auto size = static_cast<Index>(ring_.size());
    const Index kept = ring_[kept_place];
    if (!closed_ && spokes_.size() == 1 && mesh_.edges[next(spokes_[0])].twin == no_index)
        return false; // a lone triangle
    if (closed_ && size == 3) {
        const Index opposite = mesh_.edges[next(spokes_[(kept_place + 1) % 3])].twin;
        if (opposite != no_index && mesh_.edges[previous(opposite)].origin == kept)
            return false; // a tetrahedron
    }
    const auto beside = [&](Index i) {
        return closed_ ? (i + 1) % size == kept_place || (kept_place + 1) % size == i
                       : i + 1 == kept_place || kept_place + 1 == i;
    };
    const auto forbidden = [&](Index w) {
        for (Index i = 0; i < size; ++i)
            if (ring_[i] == w)
                return !beside(i);
        return false;
    };
    const Index start = mesh_.leaving[kept];
    Index h = start, last = h;
    do {
        if (forbidden(mesh_.target(h)))
            return false;
        last = h;
        h = mesh_.turn(h);
    } while (h != start && h != no_index);
    return h == start || !forbidden(mesh_.edges[previous(last)].origin);
}

/// No surviving triangle turns too far.
bool Decimator::keeps_normals(Index v, Index kept_place) const {
    const Vec3& from = sites_.site[v].position;
    const Vec3& to = sites_.site[ring_[kept_place]].position;
    const std::size_t size = ring_.size();
    for (std::size_t i = 0; i < spokes_.size(); ++i) {
        const std::size_t j = i + 1 == size ? 0 : i + 1;
        if (i == kept_place || j == kept_place)
            continue; // vanishes
        const Vec3& a = sites_.site[ring_[i]].position;
        const Vec3& b = sites_.site[ring_[j]].position;
        const Vec3 old_normal = (a - from).cross(b - from), new_normal = (a - to).cross(b - to);
        const double old2 = old_normal.squaredNorm(), dot = old_normal.dot(new_normal);
        if (old2 > 0 && (dot <= 0 || dot * dot < least_cosine2_ * old2 * new_normal.squaredNorm()))
            return false;
    }
    return true;
}

void Decimator::collapse(Index v, Index kept_place) {
    if (closed_) { // the kept vertex comes first
        std::rotate(ring_.begin(), ring_.begin() + kept_place, ring_.end());
        std::rotate(spokes_.begin(), spokes_.begin() + kept_place, spokes_.end());
        kept_place = 0;
    }
    const Index kept = ring_[kept_place];
    if (observer_)
        observer_->collapse({v, kept, closed_, ring_, spokes_,
                             spokes_.size() == 1 ? mesh_.edges[next(spokes_[0])].twin : no_index});

    const double total = cost(v, kept);
    Quadric& quadric = sites_.quadric[kept];
    quadric.merge(sites_.quadric[v], offset(v, kept));
    sites_.site[kept].constant = total;
    if (const double weight = quadric.trace(); weight > 0)
        largest_error_ = std::max(largest_error_, total / weight);

    stitch(v, kept_place);
    reconsider(kept);
}

/// Rewrites the half-edges around v: what began there begins at the kept vertex, and the triangles at the edge
/// between them vanish.
void Decimator::stitch(Index v, Index kept_place) {
    const Index kept = ring_[kept_place];
    for (Index h : spokes_)
        mesh_.edges[h].origin = kept;
    if (kept_place == 0)
        fold_first(kept);
    if (closed_ || kept_place != 0)
        fold_last(kept);
    mesh_.leaving[v] = no_index;
    keys_[v] = no_cost;
}

/// Triangle (v, kept, b): its sides (kept, b) and (b, v) become one edge.
void Decimator::fold_first(Index kept) {
    const Index spoke = spokes_.front(), far = next(spoke), back = previous(spoke);
    replace_leaving(kept, far, mesh_.edges[back].twin);
    replace_leaving(ring_[1], back, mesh_.edges[far].twin);
    fold(spoke, far, back);
}

/// Triangle (v, a, kept): its sides (v, a) and (a, kept) become one edge.
void Decimator::fold_last(Index kept) {
    const Index spoke = spokes_.back(), far = next(spoke), back = previous(spoke);
    const Index a = ring_[spokes_.size() - 1];
    replace_leaving(a, far, mesh_.edges[spoke].twin);
    if (closed_)
        replace_leaving(kept, back, spokes_[1]);
    else // the boundary now leaves the kept vertex where it left v
        replace_leaving(kept, back, spokes_.size() > 1 ? spokes_.front() : mesh_.edges[far].twin);
    fold(spoke, spoke, far);
}

void Decimator::replace_leaving(Index v, Index gone, Index instead) {
    if (mesh_.leaving[v] == gone)
        mesh_.leaving[v] = instead;
}

/// Removes the triangle of `spoke`; what lay beyond its sides x and y becomes adjacent.
void Decimator::fold(Index spoke, Index x, Index y) {
    const Index beyond_x = mesh_.edges[x].twin, beyond_y = mesh_.edges[y].twin;
    if (beyond_x != no_index)
        mesh_.edges[beyond_x].twin = beyond_y;
    if (beyond_y != no_index)
        mesh_.edges[beyond_y].twin = beyond_x;
    for (Index h : {spoke, next(spoke), previous(spoke)})
        mesh_.edges[h].origin = no_index;
}

/// The only costs that may have fallen are those of the new edges, which all end at `kept`.
void Decimator::reconsider(Index kept) {
    double least = std::numeric_limits<double>::max();
    for (Index w : ring_) {
        if (w == kept)
            continue;
        least = std::min(least, cost(kept, w));
        const bool allowed = sites_.kind[w] == Kind::interior || sites_.kind[kept] != Kind::interior;
        if (allowed || keys_[w] == no_cost) // a vertex that was stuck gets another chance
            lower_key(w, cost(w, kept));
    }
    lower_key(kept, least);
}

void Decimator::lower_key(Index v, double cost) {
    const CostKey key = cost_key(cost);
    if (key >= keys_[v] || sites_.kind[v] == Kind::locked)
        return;
    keys_[v] = key;
    queue_.push(candidate(key, v));
}

} // namespace wm3d::simplify
