// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Hinges: the edges of a surface with the two triangles at each, and how far these are from one plane.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::detect {

/// The edges with two triangles, and for each the fold r = n . sum_k c_k x_k over its two ends and the two corners
/// opposite: c is the affine dependency of the four after unfolding, of length 1, and n the mean normal. Two coplanar
/// triangles have r = 0; independent moves of vertices by s along n change any fold by s in the root mean square.
/// Left out are edges without length, with triangles without area, and those folded back to 180 degrees.
class Hinges {
public:
    /// \param normals  unit normals of the vertices, #V, along which moves are made
    Hinges(const TriangleMesh& mesh, std::span<const Vec3> normals);

    std::size_t size() const { return ends_.size(); }

    /// The vertices of each hinge: the ends of the edge and the two corners opposite.
    std::span<const std::array<Index, 4>> ends() const { return ends_; }

    /// The entries of J at these: what a move of each vertex along its normal adds to the fold.
    std::span<const std::array<double, 4>> couplings() const { return couplings_; }

    /// r of the mesh as it is, #hinges.
    std::span<const double> folds() const { return folds_; }

    /// J q: what moves q along the vertices' normals, #V, add to r; the hinges' normals held.
    std::vector<double> folds_of(std::span<const double> moves) const;

    /// J^T y, #V, summed in the order of the hinges.
    std::vector<double> transposed(std::span<const double> y) const;

    /// The diagonal of J^T diag(g) J, #V, for weights g of the hinges.
    std::vector<double> squares(std::span<const double> g) const;

    /// The sum of y_h c_k n_h at each vertex, #V: how the sum of y_h r_h grows with its moves in any direction.
    /// \param positions  those of the mesh
    std::vector<Vec3> gradient(std::span<const Vec3> positions, std::span<const double> y) const;

private:
    std::size_t vertices_;
    std::vector<std::array<Index, 4>> ends_;
    std::vector<std::array<double, 4>> couplings_;
    std::vector<double> folds_;
};

} // namespace wm3d::detect
