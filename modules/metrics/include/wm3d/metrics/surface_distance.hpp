// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Distances from one surface to another, by samples spread evenly over the area.
#pragma once

#include <cstddef>
#include <vector>

#include <wm3d/metrics/surface_tree.hpp>

namespace wm3d::metrics {

/// Distance of a surface from another, not the other way around.
struct OneSidedDistance {
    double mean = 0; ///< area-weighted mean of the distance, in units of the mesh
    double rms = 0;  ///< area-weighted root mean square of the distance
    double max = 0;  ///< largest distance of a sample or a vertex: the one-sided Hausdorff distance
    double normal_deviation =
        0; ///< area-weighted mean angle between the normals at a sample and at its closest point, degrees
    std::size_t samples = 0; ///< samples inside triangles
    double spacing = 0; ///< root of the area per sample: the density of the samples, in units of the mesh
};

/// Cuts each triangle into m^2 like triangles, with m the least that gives `samples` samples or more on the
/// whole surface in proportion to area, and takes each part's centre: the same samples for the same mesh. The
/// largest distance is taken over these samples and the vertices.
/// \pre  samples > 0
OneSidedDistance surface_distance(const TriangleMesh& from, const SurfaceTree& to, std::size_t samples);

/// Distance of every vertex of `mesh` from the surface of `reference`, #V.
std::vector<double> vertex_distances(const TriangleMesh& mesh, const SurfaceTree& reference);

} // namespace wm3d::metrics
