// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  A tree of boxes over triangles.
///
/// Ours and not a library's, because mark builds it: libraries at hand bring a large header (CGAL), single
/// precision (Embree), or no bound to start a search from, which saves most of the search where an answer
/// that is nearly right is known.
#pragma once

#include <span>
#include <vector>

#include <Eigen/Geometry>

#include <wm3d/mesh/triangle_mesh.hpp>

#include "closest_on_triangle.hpp"

namespace wm3d::metrics {

inline bool has_corner(const Triangle& t, Index vertex) {
    return t[0] == vertex || t[1] == vertex || t[2] == vertex;
}

/// Three corners of a triangle and the number that the caller knows it by.
struct NumberedTriangle {
    Vec3 a, b, c;
    Index number;
};

inline NumberedTriangle numbered(const TriangleMesh& mesh, Index triangle) {
    const Triangle& t = mesh.triangles[triangle];
    return {mesh.positions[t[0]], mesh.positions[t[1]], mesh.positions[t[2]], triangle};
}

/// A triangle and how far away it is.
struct NearestTriangle {
    Index triangle = no_index;
    double square = std::numeric_limits<double>::infinity(); ///< squared distance
    double height = -1; ///< squared distance from the triangle's plane; less than any where unknown

    /// Takes another triangle if it is closer to the query. Beyond a convex edge or corner several are
    /// equally close: the one that faces the query most squarely is taken, and if these are several, that of
    /// lowest number.
    void improve(const Vec3& query, const NumberedTriangle& other);

    /// Whether a triangle at such a distance may be taken.
    bool may_yield_to(double other_square) const { return other_square <= square * (1 + same); }

private:
    static constexpr double same = 1e-10; ///< relative difference that rounding makes
};

inline void NearestTriangle::improve(const Vec3& query, const NumberedTriangle& other) {
    const double other_square = squared_distance_to_triangle(query, other.a, other.b, other.c);
    if (!may_yield_to(other_square))
        return;
    const Vec3 normal = (other.b - other.a).cross(other.c - other.a);
    const double along = normal.dot(query - other.a), other_height = along * along / normal.squaredNorm();
    const bool closer = other_square < square * (1 - same);
    const bool squarer = other_height > height * (1 + same);
    const bool as_square = other_height >= height * (1 - same);
    if (closer || squarer || (as_square && other.number < triangle))
        *this = {other.number, other_square, other_height};
}

/// A perfect binary tree in one array, as in a heap: the children of node k are 2 k + 1 and 2 k + 2. Node k
/// covers a run of triangles that follows from k, so nodes hold a box and nothing else.
class TriangleBoxes {
public:
    /// Over some triangles of a mesh, which has to outlive the tree.
    /// \pre  triangles is not empty
    TriangleBoxes(const TriangleMesh& mesh, std::vector<Index> triangles);

    /// The triangle closest to the query, in the sense of `improve`. `known` is an answer that may be
    /// bettered: the closer it is, the shorter the search.
    NearestTriangle nearest(const Vec3& query, NearestTriangle known = {}) const;

    /// Distance of each vertex of the mesh from the triangles that it is no corner of, #V, or `most` if they are all
    /// farther; 0 for corners of no triangle of the tree.
    std::vector<double> clearances(double most) const;

private:
    struct Box {
        Vec3 min, max;
        double squared_distance(const Vec3& p) const {
            return (min - p).cwiseMax(p - max).cwiseMax(0.0).squaredNorm();
        }
        void include(const Box& other) {
            min = min.cwiseMin(other.min);
            max = max.cwiseMax(other.max);
        }
        bool meets(const Box& other) const {
            return (min.array() <= other.max.array()).all() && (other.min.array() <= max.array()).all();
        }
    };

    /// A node and the run of triangles that it covers.
    struct Branch {
        std::size_t node, begin, end;

        std::size_t half() const { return begin + (end - begin + 1) / 2; }
        Branch left() const { return {2 * node + 1, begin, half()}; }
        Branch right() const { return {2 * node + 2, half(), end}; }
    };

    struct Boxed {
        Box box;
        Index triangle;
    };

    template<typename Wanted>
    NearestTriangle search(const Vec3& query, NearestTriangle known, Wanted&& wanted) const;
    Box box_of(Index triangle) const;
    std::vector<Index> meeting(const Box& box, std::size_t most) const;
    double clearance(Index vertex, double most) const;
    double clearance(Index vertex, std::span<const Boxed> triangles, double most) const;
    void clear(std::span<const Index> vertices, double most, std::vector<double>& clearances) const;
    void halve(const Branch& branch, const std::vector<Vec3>& centres);
    void build(const Branch& branch, const std::vector<Vec3>& centres);
    Branch root() const { return {0, 0, triangles_.size()}; }
    bool is_leaf(const Branch& branch) const { return 2 * branch.node + 1 >= boxes_.size(); }
    std::span<const Index> triangles_of(const Branch& branch) const {
        return std::span(triangles_).subspan(branch.begin, branch.end - branch.begin);
    }

    const TriangleMesh& mesh_;
    std::vector<Index> triangles_; ///< leaf by leaf
    std::vector<Box> boxes_;       ///< one less than a power of two
};

} // namespace wm3d::metrics
