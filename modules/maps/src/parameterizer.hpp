// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The map Pi, built collapse by collapse.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <wm3d/maps/base_domain.hpp>
#include <wm3d/simplify/observer.hpp>

#include "flatten.hpp"

namespace wm3d::maps {

/// Follows a simplification and keeps the place of every removed vertex on the current mesh.
class Parameterizer : public simplify::Observer {
public:
    /// `domain` receives `point` and the counts.
    Parameterizer(std::size_t input_vertices, BaseDomain& domain);

    void start(const simplify::WorkingSurface& surface) override;
    void collapse(const simplify::Collapse& step) override;
    void finish(std::span<const Index> faces) override;

private:
    /// Place of a removed vertex; the vertices of one face form a list.
    struct Place {
        std::array<double, 3> barycentric; ///< of corners 3 f, 3 f + 1, 3 f + 2
        Index next;                        ///< next vertex of the same face
    };

    /// A triangle of the new fan in the plane: (kept, first, second) with what its coordinates need.
    struct FanTriangle {
        Vec2 to_first, to_second; ///< from kept, divided by twice the area
        Index corner;             ///< at kept
    };

    struct Moved {
        Index vertex;
        Vec2 at;
    };

    void lay_out(const simplify::Collapse& step);
    void collect(const simplify::Collapse& step);
    void build_fan(const simplify::Collapse& step);
    void settle(const Moved& moved);
    void settle_on_boundary(const simplify::Collapse& step, const Moved& moved);
    void put(Index vertex, Index corner, double first, double second);

    simplify::WorkingSurface surface_;
    BaseDomain& domain_;
    std::vector<Place> place_;     ///< #W
    std::vector<Index> face_head_; ///< #F: first vertex of the list

    // the collapse in hand
    std::vector<Vec3> ring_;
    std::vector<Vec2> plane_;
    std::vector<Moved> moved_;
    std::vector<FanTriangle> fan_;
    bool folded_ = false; ///< the flattening turned a triangle of the fan over
    Vec2 kept_;
    Index any_corner_ = no_index; ///< at kept, of a surviving triangle
};

} // namespace wm3d::maps
