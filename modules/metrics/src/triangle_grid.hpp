// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  A grid of triangles, for what lies close by.
#pragma once

#include <array>
#include <cmath>
#include <cstdint>
#include <optional>
#include <span>
#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>

#include "triangle_boxes.hpp"

namespace wm3d::metrics {

/// Equal cells over the box of a surface and the triangles whose boxes meet each: made in a third of the time that a tree
/// of boxes takes, and searched in less where triangles are of about one size and no query lies far off.
class TriangleGrid {
public:
    /// Over some triangles of a mesh, which has to outlive the grid. Nothing where most cells would be met by many.
    static std::optional<TriangleGrid> over(const TriangleMesh& mesh, std::span<const Index> triangles);

    /// What is less than the distance of each vertex of the mesh from the triangles that it is no corner of, #V, and at most
    /// `most`.
    std::vector<double> clearances(double most) const;

    /// The triangle closest to where a vertex went, in the sense of NearestTriangle. Nothing where too many cells would
    /// have to be looked into, or where none of the vertex's own triangles is in the grid.
    /// \param own  the triangles at the vertex
    std::optional<Index> nearest(const Vec3& query, Index vertex, std::span<const Index> own) const;

private:
    using Corner =
        Eigen::Array4f; // x, y, z from the grid's corner, in units of its longest side; the last is 0

    /// A ball that holds the triangle, for all that its numbers are rounded.
    struct Ball {
        Corner centre; ///< and its radius, last
        /// What the distance of a point from the triangle is not less than, or something below 0.
        float clearance(const Corner& p) const {
            return std::sqrt((p - centre).head<3>().square().sum()) - centre[3];
        }
        bool meets(const Corner& p, float within) const {
            const float reach = centre[3] + within;
            return (p - centre).head<3>().square().sum() <= reach * reach;
        }
    };
    struct Cells {
        std::array<std::uint16_t, 3> first, last;
        std::size_t count() const;
    };

    TriangleGrid(const TriangleMesh& mesh, std::span<const Index> triangles);
    bool has(Index triangle) const { return balls_[triangle].centre[3] >= 0; }
    Corner corner(const Vec3& p) const;
    Cells cells(const Corner& min, const Corner& max) const;
    Cells take(Index triangle);
    void file(std::span<const Index> triangles, std::span<const Cells> met, std::size_t count);
    Cells cells_around(const Corner& p, float radius) const;
    float clearance(Index vertex, float most) const;
    template<typename Visit>
    void for_each(const Cells& cells, Visit&& visit) const;
    void improve(NearestTriangle& known, const Vec3& query, Index triangle) const;

    const TriangleMesh* mesh_;
    Vec3 origin_ = Vec3::Zero();
    double per_unit_ = 0; ///< 1 / the longest side
    float per_cell_ = 0;
    std::array<std::uint16_t, 3> size_{1, 1, 1};
    std::vector<Ball> balls_;      ///< #F, of negative radius where the grid doesn't have the triangle
    std::vector<Index> first_;     ///< of each cell in `triangles_`, and the end
    std::vector<Index> triangles_; ///< cell by cell
};

} // namespace wm3d::metrics
