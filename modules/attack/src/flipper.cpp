// SPDX-License-Identifier: GPL-3.0-or-later
#include "flipper.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace wm3d::attack {

namespace {

std::uint64_t edge_key(Index a, Index b) {
    return std::uint64_t{std::min(a, b)} << 32 | std::max(a, b);
}

} // namespace

Flipper::Flipper(const TriangleMesh& mesh, double max_angle_degrees)
    : mesh_(mesh), min_cosine_(std::cos(max_angle_degrees * std::numbers::pi / 180)),
      twin_(3 * mesh.triangles.size(), no_index) {
    std::vector<std::pair<std::uint64_t, Index>> sides;
    sides.reserve(twin_.size());
    for (Index h = 0; h < twin_.size(); ++h)
        sides.emplace_back(edge_key(origin(h), origin(next(h))), h);
    std::sort(sides.begin(), sides.end());
    edges_.reserve(sides.size());
    for (std::size_t i = 0; i < sides.size();) {
        std::size_t end = i + 1;
        while (end < sides.size() && sides[end].first == sides[i].first)
            ++end;
        edges_.insert(sides[i].first);
        if (end - i == 2 && origin(sides[i].second) != origin(sides[i + 1].second))
            pair(sides[i].second, sides[i + 1].second);
        i = end;
    }
}

std::vector<Index> Flipper::inner_edges() const {
    std::vector<Index> inner;
    for (Index h = 0; h < twin_.size(); ++h)
        if (twin_[h] != no_index && h < twin_[h])
            inner.push_back(h);
    return inner;
}

Flipper::Quad Flipper::quad(Index h) const {
    return {origin(h), origin(next(h)), origin(previous(h)), origin(previous(twin_[h]))};
}

bool Flipper::is_delaunay(Index h) const {
    if (twin_[h] == no_index)
        return true;
    const Quad q = quad(h);
    const auto cotangent = [&](Index apex) {
        const Vec3 u = mesh_.positions[q.a] - mesh_.positions[apex];
        const Vec3 v = mesh_.positions[q.b] - mesh_.positions[apex];
        return u.dot(v) / u.cross(v).norm();
    };
    return !(cotangent(q.c) + cotangent(q.d) < -1e-9); // cot x + cot y < 0 where x + y > 180 degrees
}

bool Flipper::is_flat(const Quad& q) const {
    const auto normal = [&](Index i, Index j, Index k) -> Vec3 {
        const Vec3& p = mesh_.positions[i];
        return (mesh_.positions[j] - p).cross(mesh_.positions[k] - p);
    };
    const Vec3 before[] = {normal(q.a, q.b, q.c), normal(q.b, q.a, q.d)};
    const Vec3 after[] = {normal(q.a, q.d, q.c), normal(q.d, q.b, q.c)};
    const Vec3 common = (before[0] + before[1]).normalized();
    const auto along_common = [&](const Vec3& n) {
        return n.norm() > 0 && n.dot(common) >= min_cosine_ * n.norm();
    };
    return std::all_of(std::begin(before), std::end(before), along_common) &&
           std::all_of(std::begin(after), std::end(after), along_common);
}

bool Flipper::may_flip(Index h) const {
    if (twin_[h] == no_index)
        return false;
    const Quad q = quad(h);
    return q.c != q.d && !edges_.contains(edge_key(q.c, q.d)) && is_flat(q);
}

std::array<Index, 4> Flipper::flip(Index h) {
    const Index t = twin_[h];
    const auto [a, b, c, d] = quad(h);
    const Index outer[] = {twin_[next(t)], twin_[previous(h)], twin_[previous(t)],
                           twin_[next(h)]}; // ad ca db bc
    const Index f = 3 * (h / 3), g = 3 * (t / 3);
    mesh_.triangles[h / 3] = {a, d, c};
    mesh_.triangles[t / 3] = {d, b, c};
    pair(f + 1, g + 2);
    const std::array<Index, 4> sides{f, f + 2, g, g + 1};
    for (int k = 0; k < 4; ++k)
        pair(sides[k], outer[k]);
    edges_.erase(edge_key(a, b));
    edges_.insert(edge_key(c, d));
    return sides;
}

void Flipper::pair(Index h, Index twin) {
    twin_[h] = twin;
    if (twin != no_index)
        twin_[twin] = h;
}

} // namespace wm3d::attack
