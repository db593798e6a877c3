// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Where a coarse suspect's vertices took their moves from.
#pragma once

#include <array>
#include <span>
#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::detect {

/// Points on the triangles of a coarse mesh, each with its share of the three corners. A simplification that
/// places a vertex anew gives it the mean move of the surface around it, not the move at one point; so what
/// is read at the vertex is spread over the points around it before it meets the bumps.
class CellSamples {
public:
    /// At least `count` points, as many on each triangle.
    /// \pre  the mesh has triangles and count > 0
    CellSamples(const TriangleMesh& mesh, std::size_t count);

    /// #samples points on the surface.
    const std::vector<Vec3>& positions() const { return positions_; }

    /// y of the vertices, #V, spread over the points, #samples; the sum stays. A point counts with its area
    /// and the cube of its barycentric coordinate: near the vertex most.
    std::vector<double> spread(std::span<const double> y) const;

private:
    std::vector<Vec3> positions_;
    std::vector<Triangle> corners_;             ///< per sample
    std::vector<std::array<double, 3>> shares_; ///< per sample: of its corners
};

} // namespace wm3d::detect
