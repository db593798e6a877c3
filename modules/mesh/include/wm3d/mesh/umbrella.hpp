// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The umbrella operator U(v) = mean of the neighbours - v, by which meshes are smoothed, and its
/// transpose.
#pragma once

#include <span>
#include <vector>

#include <wm3d/mesh/neighbours.hpp>

namespace wm3d {

/// The smoothing step S = I + weight U of a mesh, all vertices at once. Vertices of a border and isolated
/// ones stay.
class Umbrella {
public:
    explicit Umbrella(const TriangleMesh& mesh) : neighbours_(mesh) {}

    /// S^steps x: vectors of any meaning, one a vertex.
    std::vector<Vec3> smooth(std::vector<Vec3> x, int steps, double weight) const;

    /// (S^T)^steps x: how much each vertex contributes to what `smooth` gives.
    std::vector<Vec3> smooth_transposed(std::vector<Vec3> x, int steps, double weight) const;

private:
    bool stays(std::size_t vertex) const {
        return neighbours_.of(vertex).empty() || neighbours_.on_border(vertex);
    }
    double share(std::size_t vertex) const { return 1 / static_cast<double>(neighbours_.of(vertex).size()); }

    Neighbours neighbours_;
};

} // namespace wm3d
