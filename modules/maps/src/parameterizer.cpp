// SPDX-License-Identifier: GPL-3.0-or-later
#include "parameterizer.hpp"

#include <algorithm>
#include <limits>

namespace wm3d::maps {

namespace {

/// Coordinates smaller than this are rounding.
constexpr double negligible = 1e-13;

Index next_corner(Index c) {
    return c % 3 == 2 ? c - 2 : c + 1;
}

} // namespace

Parameterizer::Parameterizer(std::size_t input_vertices, BaseDomain& domain) : domain_(domain) {
    domain_.point.assign(input_vertices, SurfacePoint{});
}

void Parameterizer::start(const simplify::WorkingSurface& surface) {
    surface_ = surface;
    place_.resize(surface.positions.size());
    face_head_.assign(surface.corners.size() / 3, no_index);
}

void Parameterizer::collapse(const simplify::Collapse& step) {
    lay_out(step);
    collect(step);
    build_fan(step);
    for (const Moved& moved : moved_) {
        if (!step.closed() && moved.at[1] == 0)
            settle_on_boundary(step, moved);
        else
            settle(moved);
    }
    domain_.relocations += moved_.size();
    domain_.folded += folded_ ? moved_.size() : 0;
}

/// Flattens the ring of the removed vertex.
void Parameterizer::lay_out(const simplify::Collapse& step) {
    const Vec3& centre = surface_.positions[step.removed];
    ring_.clear();
    for (const simplify::Spoke& s : step.ring)
        ring_.push_back(surface_.positions[s.vertex] - centre);
    flatten(ring_, step.closed(), plane_);
    kept_ = plane_[step.place];
}

/// Takes the vertices of all triangles of the ring, with where they lie in the plane.
void Parameterizer::collect(const simplify::Collapse& step) {
    moved_.clear();
    moved_.push_back({step.removed, Vec2::Zero()});
    for (std::size_t i = 0; i < step.ring.size(); ++i) {
        const Index corner = step.ring[i].corner;
        if (corner == no_index)
            continue;
        const Index first = next_corner(corner) % 3, second = next_corner(next_corner(corner)) % 3;
        const Vec2 &p = plane_[i], &q = plane_[i + 1 == plane_.size() ? 0 : i + 1];
        for (Index v = face_head_[corner / 3]; v != no_index; v = place_[v].next) {
            const auto& b = place_[v].barycentric;
            moved_.push_back({v, b[first] * p + b[second] * q});
        }
        face_head_[corner / 3] = no_index;
    }
}

/// The surviving triangles, from the kept vertex; those the flattening turned over are left out.
void Parameterizer::build_fan(const simplify::Collapse& step) {
    fan_.clear();
    folded_ = false;
    for (std::size_t i = 0; i < step.ring.size(); ++i) {
        const std::size_t j = i + 1 == plane_.size() ? 0 : i + 1;
        if (i == step.place || j == step.place || step.ring[i].corner == no_index)
            continue; // vanishes
        any_corner_ = step.ring[i].corner;
        const Vec2 first = plane_[i] - kept_, second = plane_[j] - kept_;
        const double double_area = cross(first, second);
        folded_ = folded_ || !(double_area > 0);
        if (double_area > 0)
            fan_.push_back({first / double_area, second / double_area, any_corner_});
    }
}

/// Finds the fan triangle that holds the point, or else the one it is least outside of; in a folded fan,
/// where several may hold it, the one in which it lies deepest.
void Parameterizer::settle(const Moved& moved) {
    const Vec2 d = moved.at - kept_;
    double best = -std::numeric_limits<double>::infinity(), first = 0, second = 0;
    Index corner = any_corner_; // if the whole fan is flat, the kept vertex itself
    for (const FanTriangle& t : fan_) {
        const double u = cross(d, t.to_second), v = cross(t.to_first, d);
        const double least = std::min({u, v, 1 - u - v});
        if (least > best) {
            best = least, first = u, second = v, corner = t.corner;
            if (best >= 0 && !folded_)
                break;
        }
    }
    domain_.clamped += best < -negligible;
    put(moved.vertex, corner, first, second);
}

/// A point of the straight line to which an open ring opens its boundary: it goes to the boundary edge
/// between the ends of the ring, and so stays on the boundary.
void Parameterizer::settle_on_boundary(const simplify::Collapse& step, const Moved& moved) {
    const double begin = plane_.front()[0], end = plane_.back()[0]; // begin >= 0 >= end
    const double length = begin - end;
    const double to_front = length > 0 ? std::clamp((moved.at[0] - end) / length, 0.0, 1.0) : 1;
    if (step.ring.size() == 2)
        put(moved.vertex, step.beyond, to_front, 0);
    else if (step.place == 0)
        put(moved.vertex, step.ring[step.ring.size() - 2].corner, 0, 1 - to_front);
    else
        put(moved.vertex, step.ring.front().corner, to_front, 0);
}

/// Gives the vertex its place: coordinates `first` and `second` of the two corners after `corner`.
void Parameterizer::put(Index vertex, Index corner, double first, double second) {
    std::array<double, 3> c{1 - first - second, first, second};
    for (double& x : c)
        x = x < negligible ? 0 : x;
    const double sum = c[0] + c[1] + c[2];
    Place& place = place_[vertex];
    const Index k = corner % 3;
    place.barycentric[k] = c[0] / sum;
    place.barycentric[(k + 1) % 3] = c[1] / sum;
    place.barycentric[(k + 2) % 3] = c[2] / sum;
    Index& head = face_head_[corner / 3];
    place.next = head;
    head = vertex;
}

void Parameterizer::finish(std::span<const Index> faces) {
    for (std::size_t t = 0; t < faces.size(); ++t)
        for (Index v = face_head_[faces[t]]; v != no_index; v = place_[v].next) {
            const auto& b = place_[v].barycentric;
            domain_.point[surface_.input_vertex[v]] = {static_cast<Index>(t), {b[0], b[1], b[2]}};
        }
}

} // namespace wm3d::maps
