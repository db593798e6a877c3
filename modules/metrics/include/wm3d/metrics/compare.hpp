// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  All figures of the distance between two meshes at once.
#pragma once

#include <optional>

#include <wm3d/core/progress.hpp>
#include <wm3d/metrics/msdm2.hpp>
#include <wm3d/metrics/surface_distance.hpp>

namespace wm3d::metrics {

struct Options {
    std::size_t samples = 200'000; ///< on each surface, at least one per triangle
    bool perceptual = true;        ///< also compute MSDM2, both ways
    Msdm2Options msdm2{};
};

/// Vertex i of one mesh against vertex i of the other. Lengths in units of the file.
struct VertexFigures {
    double rms = 0;        ///< root mean square of the moves
    double max = 0;        ///< longest move
    double normal_rms = 0; ///< area-weighted RMS of the moves along the first mesh's vertex normals
    double snr = 0; ///< 10 log10 of the sum of squared distances to the mean vertex over that of the moves,
                    ///< dB; infinite where nothing moved
};

/// Lengths in units of the file; `percent` puts them in % of the first mesh's box diagonal.
struct Report {
    double diagonal = 0;                   ///< of the box of the first mesh's surface
    std::optional<VertexFigures> vertices; ///< where both have the same number of vertices
    bool same_triangles = false;           ///< whether both index the same triangles
    OneSidedDistance forward;              ///< from the first surface to the second
    OneSidedDistance backward;             ///< from the second to the first
    double mrms = 0;                       ///< larger of the two one-sided RMS distances
    double hausdorff = 0;                  ///< larger of the two one-sided largest distances
    double normal_deviation = 0;           ///< mean of the two one-sided mean angles between normals, degrees
    double area_change = 0;                ///< of the second area against the first, %
    std::optional<double> volume_change; ///< of the second volume against the first, %, where both are closed
    std::optional<double>
        msdm2; ///< of the second mesh against the first, the published figure, where asked for
    std::optional<double> msdm2_both; ///< mean of that and the first against the second

    double percent(double length) const { return 100 * length / diagonal; }
};

/// Compares two meshes that lie in the same place; the first is the reference.
/// \throw GeometryError   if one of them has no surface area
/// \throw ParameterError  if no samples are asked for
Report compare(const TriangleMesh& a, const TriangleMesh& b, const Options& options = {},
               const Progress& progress = {});

/// \pre  both have the same number of vertices, and at least one
VertexFigures compare_vertices(const TriangleMesh& a, const TriangleMesh& b);

} // namespace wm3d::metrics
