// SPDX-License-Identifier: GPL-3.0-or-later
#include "chart.hpp"

#include <algorithm>
#include <cmath>
#include <utility>

namespace wm3d::maps {

namespace {

constexpr std::size_t farthest = 400; ///< triangles laid out at most

Index corner_after(Index h) {
    return h % 3 == 2 ? h - 2 : h + 1;
}

/// For each half-edge 3 f + k (corner k to k + 1) the next one of the same edge, around in a cycle; itself if
/// alone.
std::vector<Index> edge_cycles(const std::vector<Triangle>& triangles) {
    const auto vertex = [&](Index h) { return triangles[h / 3][h % 3]; };
    std::vector<std::pair<std::uint64_t, Index>> edges;
    edges.reserve(3 * triangles.size());
    for (Index h = 0; h < 3 * triangles.size(); ++h) {
        const auto [low, high] = std::minmax({vertex(h), vertex(corner_after(h))});
        edges.emplace_back((static_cast<std::uint64_t>(low) << 32) | high, h);
    }
    std::sort(edges.begin(), edges.end());
    std::vector<Index> following(edges.size());
    for (std::size_t begin = 0, end; begin < edges.size(); begin = end) {
        for (end = begin + 1; end < edges.size() && edges[end].first == edges[begin].first; ++end)
            following[edges[end - 1].second] = edges[end].second;
        following[edges[end - 1].second] = edges[begin].second;
    }
    return following;
}

} // namespace

Unfolder::Unfolder(const TriangleMesh& base)
    : base_(base), beside_(edge_cycles(base.triangles)), star_start_(base.positions.size() + 1, 0),
      star_(3 * base.triangles.size()), visited_(base.triangles.size(), 0) {
    for (const Triangle& t : base.triangles)
        for (Index v : t)
            ++star_start_[v + 1];
    for (std::size_t v = 1; v < star_start_.size(); ++v)
        star_start_[v] += star_start_[v - 1];
    std::vector<Index> at(star_start_.begin(), star_start_.end() - 1);
    for (Index f = 0; f < base.triangles.size(); ++f)
        for (Index v : base.triangles[f])
            star_[at[v]++] = f;
}

/// A point lies in every triangle that has the vertices on which its coordinates are not zero.
bool Unfolder::holds(Index triangle, const SurfacePoint& point) const {
    const Triangle &t = base_.triangles[triangle], &own = base_.triangles[point.triangle];
    for (int k = 0; k < 3; ++k)
        if (point.barycentric[k] > 0 && std::find(t.begin(), t.end(), own[k]) == t.end())
            return false;
    return true;
}

/// The triangle that holds most of the points, among those around the first one.
Index Unfolder::home_of(std::span<const SurfacePoint, 3> points) const {
    Index home = points[0].triangle;
    std::ptrdiff_t most = 0;
    for (const SurfacePoint& point : points)
        for (int k = 0; k < 3; ++k) {
            const Index v = base_.triangles[point.triangle][k];
            if (!(point.barycentric[k] > 0))
                continue;
            for (Index i = star_start_[v]; i < star_start_[v + 1]; ++i) {
                const auto held = std::count_if(points.begin(), points.end(),
                                                [&](const SurfacePoint& p) { return holds(star_[i], p); });
                if (held > most) {
                    most = held;
                    home = star_[i];
                }
            }
            if (most == 3)
                return home;
        }
    return home;
}

LaidOut Unfolder::lay_first(Index triangle) const {
    const Triangle& t = base_.triangles[triangle];
    const Vec3 e1 = base_.positions[t[1]] - base_.positions[t[0]];
    const Vec3 e2 = base_.positions[t[2]] - base_.positions[t[0]];
    const double length = e1.norm();
    if (!(length > 0))
        return {triangle, {Vec2::Zero(), Vec2::Zero(), Vec2{e2.norm(), 0}}};
    return {triangle,
            {Vec2::Zero(), Vec2{length, 0}, Vec2{e1.dot(e2) / length, e1.cross(e2).norm() / length}}};
}

/// The triangle of `half_edge`, turned about the edge it shares with side `side` of `from`, to the other side
/// of it.
LaidOut Unfolder::lay_beside(const LaidOut& from, Index side, Index half_edge) const {
    const Triangle& t = base_.triangles[half_edge / 3];
    const Index k = half_edge % 3, l = (k + 1) % 3, m = (k + 2) % 3;
    LaidOut laid{half_edge / 3, {}};
    // the shared edge, with the interior of `from` on its left
    const Vec2 &a = from.corners[side], &b = from.corners[(side + 1) % 3];
    const bool same_way =
        t[k] == base_.triangles[from.triangle][side]; // neighbours that disagree on their side
    laid.corners[k] = same_way ? a : b;
    laid.corners[l] = same_way ? b : a;
    const Vec3 edge = base_.positions[t[l]] - base_.positions[t[k]];
    const Vec3 apex = base_.positions[t[m]] - base_.positions[t[k]];
    const Vec2 along = laid.corners[l] - laid.corners[k];
    const double length2 = edge.squaredNorm();
    if (!(length2 > 0)) {
        laid.corners[m] = laid.corners[k];
        return laid;
    }
    const Vec2 outward = Vec2{b[1] - a[1], a[0] - b[0]}; // to the right of a -> b
    laid.corners[m] =
        laid.corners[k] + edge.dot(apex) / length2 * along + edge.cross(apex).norm() / length2 * outward;
    return laid;
}

/// Notes the points that `laid` holds; true once all three are met.
bool Unfolder::meet(const LaidOut& laid, std::span<const SurfacePoint, 3> points) {
    const Triangle& t = base_.triangles[laid.triangle];
    for (std::size_t i = 0; i < 3; ++i) {
        if (met_[i] || !holds(laid.triangle, points[i]))
            continue;
        met_[i] = true;
        found_[i].setZero();
        const Triangle& own = base_.triangles[points[i].triangle];
        for (int k = 0; k < 3; ++k)
            if (points[i].barycentric[k] > 0)
                found_[i] +=
                    points[i].barycentric[k] *
                    laid.corners[static_cast<std::size_t>(std::find(t.begin(), t.end(), own[k]) - t.begin())];
    }
    return met_[0] && met_[1] && met_[2];
}

bool Unfolder::unfold(std::span<const SurfacePoint, 3> points) {
    ++turn_;
    met_ = {};
    laid_out_.assign(1, lay_first(home_of(points)));
    visited_[laid_out_[0].triangle] = turn_;
    if (meet(laid_out_[0], points))
        return true;
    std::size_t level_end = 1;
    bool complete = false;
    for (std::size_t i = 0; i < laid_out_.size() && laid_out_.size() < farthest; ++i) {
        if (i == level_end) {
            if (complete)
                return true;
            level_end = laid_out_.size();
        }
        for (Index side = 0; side < 3; ++side) {
            const Index h = 3 * laid_out_[i].triangle + side;
            for (Index other = beside_[h]; other != h; other = beside_[other]) {
                if (visited_[other / 3] == turn_)
                    continue;
                visited_[other / 3] = turn_;
                laid_out_.push_back(lay_beside(laid_out_[i], side, other));
                complete = meet(laid_out_.back(), points) || complete;
            }
        }
    }
    return complete;
}

} // namespace wm3d::maps
