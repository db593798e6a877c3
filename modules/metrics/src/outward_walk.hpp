// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Walking over a surface outwards from a vertex, as the published program of MSDM2 does.
#pragma once

#include <algorithm>
#include <cmath>
#include <cstddef>
#include <span>
#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>

#include "edge_graph.hpp"

namespace wm3d::metrics {

/// Starts at a vertex v and follows the edges u -> w with u = v or (w - u).(u - v) > 0 as long as w stays in
/// a sphere around v. Each step leads away from v: what is reached within a smaller sphere is the part of it
/// that lies there, so one walk serves several radii, and no edge is walked from both ends.
///
/// About half of the edges at a vertex lead outwards, which no processor foresees: all are written down, and those that
/// don't are written over.
class OutwardWalk {
public:
    struct Reached {
        Index vertex = 0;
        Vec3 place = Vec3::Zero(); ///< seen from the centre
        double square = 0;         ///< squared distance from the centre

        bool is_within(double radius) const { return square <= radius * radius; }
    };
    /// An edge from a vertex that the walk has reached to one that is farther from the centre.
    struct Step {
        Index reached = 0; ///< where it starts, by its place in `reached`
        Index to = 0, edge = 0;
        Vec3 along = Vec3::Zero();
        double outward = 0;   ///< start . along
        double to_square = 0; ///< squared distance of its end from the centre

        bool ends_within(double radius) const { return to_square <= radius * radius; }

        /// Share of the edge that lies in the sphere of this radius.
        /// \param start  where it starts
        /// \pre  start.is_within(radius)
        double share_within(double radius, const Reached& start) const {
            if (ends_within(radius))
                return 1;
            // |start + t along| = radius, the root ahead
            const double a = along.squaredNorm(), b = outward, c = start.square - radius * radius;
            return std::clamp((-b + std::sqrt(std::max(0.0, b * b - a * c))) / a, 0.0, 1.0);
        }
    };

    OutwardWalk(const TriangleMesh& mesh, const EdgeGraph& graph)
        : mesh_(mesh), graph_(graph), seen_(mesh.positions.size(), 0) {}

    /// Walks anew.
    void from(Index centre, double radius) {
        ++walk_;
        seen_[centre] = walk_;
        const Vec3 origin = mesh_.positions[centre];
        const double square_radius = radius * radius;
        make_room(0);
        reached_[0] = {centre, Vec3::Zero(), 0};
        reached_count_ = 1;
        step_count_ = 0;
        for (std::size_t i = 0; i < reached_count_; ++i) {
            const std::span<const EdgeGraph::Way> ways = graph_.ways_from(reached_[i].vertex);
            make_room(ways.size());
            const Vec3 start = reached_[i].place;
            Step* step = &steps_[step_count_];
            Reached* next = &reached_[reached_count_];
            for (const EdgeGraph::Way& way : ways) {
                const Vec3 place = mesh_.positions[way.to] - origin;
                const Vec3 along = place - start;
                const double outward = along.dot(start), square = place.squaredNorm();
                const bool taken = (i == 0) | (outward > 0);
                *step = {static_cast<Index>(i), way.to, way.edge, along, outward, square};
                step += taken;
                const bool fresh = taken & (square <= square_radius) & (seen_[way.to] != walk_);
                seen_[way.to] = fresh ? walk_ : seen_[way.to];
                *next = {way.to, place, square};
                next += fresh;
            }
            step_count_ = static_cast<std::size_t>(step - steps_.data());
            reached_count_ = static_cast<std::size_t>(next - reached_.data());
        }
    }

    /// The centre, and the vertices within the radius.
    std::span<const Reached> reached() const { return {reached_.data(), reached_count_}; }

    /// The edges that lead from them outwards.
    std::span<const Step> steps() const { return {steps_.data(), step_count_}; }

private:
    /// For as many ways more, and what is written to be written over.
    void make_room(std::size_t ways) {
        if (reached_.size() <= reached_count_ + ways)
            reached_.resize(2 * (reached_count_ + ways) + 1);
        if (steps_.size() <= step_count_ + ways)
            steps_.resize(2 * (step_count_ + ways) + 1);
    }

    const TriangleMesh& mesh_;
    const EdgeGraph& graph_;
    std::vector<Index> seen_; ///< number of the walk that reached the vertex last, #V
    Index walk_ = 0;
    std::vector<Reached> reached_; ///< and room for more
    std::vector<Step> steps_;      ///< the same
    std::size_t reached_count_ = 0, step_count_ = 0;
};

/// Centres of one block of a parallel loop: every block has marks for all vertices, which have to pay.
inline std::size_t walk_block(std::size_t vertices) {
    return std::max<std::size_t>(4096, vertices / 64);
}

} // namespace wm3d::metrics
