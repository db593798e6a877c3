// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  From the base domain back to the original surface.
#pragma once

#include <cstddef>
#include <vector>

#include <wm3d/maps/base_domain.hpp>
#include <wm3d/maps/equations.hpp>
#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::maps {

/// The inverse map of the paper, Pi^-1: finds the triangle of the original whose image on the base domain
/// holds a point, and applies equation (2) there.
///
/// Where the images of a triangle's corners lie in several base triangles, these and those between them are
/// unfolded into one plane, breadth first from a triangle that holds one image; the straight triangle between
/// the three images is what the original triangle covers. Unfoldings about different triangles of a curved
/// base domain don't fit exactly: of the triangles that hold a point the one in which it lies deepest is
/// taken, and a point in a gap goes to the triangle it is least outside of. A point that is the image of a
/// vertex always returns to that vertex, unless another vertex has the same image.
class InverseMap {
public:
    /// `original` is the mesh that `domain` was made of; neither needs to outlive the object.
    InverseMap(const TriangleMesh& original, const BaseDomain& domain);

    /// The point of the original surface: a triangle of the original and coordinates in it.
    /// \pre  base_point.triangle is one of the base mesh
    SurfacePoint locate(const SurfacePoint& base_point) const;

    /// The same as a position, by equation (2).
    Vec3 to_surface(const SurfacePoint& base_point) const;

    /// Triangles of the original whose images lie too far apart to be unfolded; no point is located in them.
    std::size_t left_out() const { return left_out_; }

private:
    /// An original triangle over a base triangle: its corners' images in barycentric coordinates of the base
    /// triangle (those outside have negative ones).
    struct Cover {
        Index triangle;
        Corners images;
    };
    struct Hit {
        const Cover* cover;
        Vec3 barycentric;
    };

    struct Placed {
        Index base_triangle;
        Cover cover;
    };

    void note_base_vertices();
    void group(const std::vector<Placed>& placed);
    Hit find(const SurfacePoint& base_point) const;
    SurfacePoint nearest_corner(const SurfacePoint& base_point) const;

    TriangleMesh original_, base_;
    std::vector<Index> start_; ///< covers of base triangle t: covers_[start_[t]] up to covers_[start_[t + 1]]
    std::vector<Cover> covers_;
    std::vector<Index> at_base_vertex_;  ///< #base vertices: a triangle of the original there
    std::vector<Index> original_vertex_; ///< #base vertices: their numbers in the original
    std::size_t left_out_ = 0;
};

} // namespace wm3d::maps
