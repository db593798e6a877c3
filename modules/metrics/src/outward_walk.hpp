// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Walking over a surface outwards from a vertex, as the published program of MSDM2 does.
#pragma once

#include <algorithm>
#include <cmath>
#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>

#include "edge_graph.hpp"

namespace wm3d::metrics {

/// An edge from a vertex that the walk has reached to one that is farther from the centre.
struct OutwardStep {
    Index from = 0, to = 0, edge = 0;
    Vec3 start;             ///< of `from`, seen from the centre
    Vec3 along;             ///< from `from` to `to`
    double from_square = 0; ///< squared distances from the centre
    double to_square = 0;

    bool starts_within(double radius) const { return from_square <= radius * radius; }
    bool ends_within(double radius) const { return to_square <= radius * radius; }

    /// Share of the edge that lies in the sphere of this radius.
    /// \pre  starts_within(radius)
    double share_within(double radius) const {
        if (ends_within(radius))
            return 1;
        // |start + t along| = radius, the root ahead
        const double a = along.squaredNorm(), b = start.dot(along), c = from_square - radius * radius;
        return std::clamp((-b + std::sqrt(std::max(0.0, b * b - a * c))) / a, 0.0, 1.0);
    }
};

/// Starts at a vertex v and follows the edges u -> w with u = v or (w - u).(u - v) > 0 as long as w stays in
/// a sphere around v. Each step leads away from v: what is reached within a smaller sphere is the part of it
/// that lies there, so one walk serves several radii, and no edge is walked from both ends.
class OutwardWalk {
public:
    OutwardWalk(const TriangleMesh& mesh, const EdgeGraph& graph)
        : mesh_(mesh), graph_(graph), seen_(mesh.positions.size(), 0) {}

    /// Calls reach(w, squared distance from v) for each vertex within `radius`, v itself left out, and
    /// step(OutwardStep) for each edge that leads from such a vertex, or from v, outwards.
    template<typename Reach, typename Step>
    void from(Index centre, double radius, Reach&& reach, Step&& step) {
        ++walk_;
        seen_[centre] = walk_;
        const Vec3 origin = mesh_.positions[centre];
        found_.assign(1, {centre, Vec3::Zero(), 0});
        OutwardStep s;
        for (std::size_t i = 0; i < found_.size(); ++i) {
            s.from = found_[i].vertex;
            s.start = found_[i].place;
            s.from_square = found_[i].square;
            for (const EdgeGraph::Way& way : graph_.ways_from(s.from)) {
                const Vec3 place = mesh_.positions[way.to] - origin;
                s.along = place - s.start;
                if (i > 0 && !(s.along.dot(s.start) > 0))
                    continue;
                s.to = way.to;
                s.edge = way.edge;
                s.to_square = place.squaredNorm();
                step(static_cast<const OutwardStep&>(s));
                if (s.to_square > radius * radius || seen_[s.to] == walk_)
                    continue;
                seen_[s.to] = walk_;
                found_.push_back({s.to, place, s.to_square});
                reach(s.to, s.to_square);
            }
        }
    }

private:
    struct Found {
        Index vertex;
        Vec3 place; ///< seen from the centre
        double square;
    };

    const TriangleMesh& mesh_;
    const EdgeGraph& graph_;
    std::vector<Index> seen_; ///< number of the walk that reached the vertex last, #V
    Index walk_ = 0;
    std::vector<Found> found_;
};

/// Centres of one block of a parallel loop: every block has marks for all vertices, which have to pay.
inline std::size_t walk_block(std::size_t vertices) {
    return std::max<std::size_t>(1024, vertices / 64);
}

} // namespace wm3d::metrics
