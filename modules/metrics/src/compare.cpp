// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/metrics/compare.hpp>

#include <algorithm>
#include <cmath>
#include <limits>

#include <wm3d/core/error.hpp>
#include <wm3d/core/parallel.hpp>
#include <wm3d/mesh/centre.hpp>
#include <wm3d/mesh/measure.hpp>
#include <wm3d/mesh/topology.hpp>

namespace wm3d::metrics {

namespace {

constexpr std::size_t sum_block = 16384;

/// Sum of term(v) over all vertices.
template<typename Term>
double sum_over(std::size_t count, Term&& term) {
    return parallel_sum_of(count, sum_block, term);
}

double change_percent(double before, double after) {
    return 100 * (after - before) / before;
}

} // namespace

VertexFigures compare_vertices(const TriangleMesh& a, const TriangleMesh& b) {
    const std::size_t count = a.positions.size();
    const Vec3 centre = vertex_mean(a);
    const double moved =
        sum_over(count, [&](std::size_t v) { return (b.positions[v] - a.positions[v]).squaredNorm(); });
    const double signal =
        sum_over(count, [&](std::size_t v) { return (a.positions[v] - centre).squaredNorm(); });

    VertexFigures figures;
    figures.rms = std::sqrt(moved / static_cast<double>(count));
    for (std::size_t v = 0; v < count; ++v)
        figures.max = std::max(figures.max, (b.positions[v] - a.positions[v]).norm());
    figures.snr = moved > 0 ? 10 * std::log10(signal / moved) : std::numeric_limits<double>::infinity();

    const std::vector<Vec3> normals = vertex_normals(a);
    const std::vector<double> areas = vertex_areas(a);
    const double along_normals = sum_over(count, [&](std::size_t v) {
        const double along = normals[v].dot(b.positions[v] - a.positions[v]);
        return areas[v] * along * along;
    });
    const double area = sum_over(count, [&](std::size_t v) { return areas[v]; });
    figures.normal_rms = area > 0 ? std::sqrt(along_normals / area) : 0;
    return figures;
}

Report compare(const TriangleMesh& a, const TriangleMesh& b, const Options& options,
               const Progress& progress) {
    if (options.samples == 0)
        throw ParameterError("a comparison needs at least one sample on each surface");
    Report result;
    result.diagonal = surface_box(a).diagonal();
    if (a.positions.size() == b.positions.size() && !a.positions.empty())
        result.vertices = compare_vertices(a, b);
    result.same_triangles = a.triangles == b.triangles;

    notify(progress, "distances", 0);
    const SurfaceTree tree_a(a), tree_b(b);
    result.forward = surface_distance(a, tree_b, options.samples);
    notify(progress, "distances", 0.5);
    result.backward = surface_distance(b, tree_a, options.samples);
    result.mrms = std::max(result.forward.rms, result.backward.rms);
    result.hausdorff = std::max(result.forward.max, result.backward.max);
    result.normal_deviation = (result.forward.normal_deviation + result.backward.normal_deviation) / 2;

    result.area_change = change_percent(surface_area(a), surface_area(b));
    if (inspect_topology(a).closed() && inspect_topology(b).closed())
        result.volume_change = change_percent(enclosed_volume(a), enclosed_volume(b));
    if (options.perceptual) {
        notify(progress, "perceptual distance", 0);
        result.msdm2 = Msdm2(tree_a, options.msdm2).distance(b);
        notify(progress, "perceptual distance", 0.5);
        result.msdm2_both = (*result.msdm2 + Msdm2(tree_b, options.msdm2).distance(a)) / 2;
    }
    notify(progress, "comparison", 1);
    return result;
}

} // namespace wm3d::metrics
