// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/watermark/suspect.hpp>

#include <algorithm>
#include <optional>

#include <wm3d/core/parallel.hpp>
#include <wm3d/resync/smoothing_trend.hpp>
#include <wm3d/watermark/pieces.hpp>

namespace wm3d::watermark {

namespace {

/// Parts by themselves keep three vertices at least, so of a cloud of triangles nothing can be simplified away.
constexpr std::size_t most_base_vertices = 60'000;

/// Triangles up to which two looks at a mesh at once are no matter of memory.
constexpr std::size_t small_beside_memory = 4'000'000;

/// Mean radius about the centroid of the outline, which most often one of the axes has found.
double outline_radius(const TriangleMesh& mesh, const WholeSurface& whole) {
    const Substance substance = search::outlined(whole.moments);
    const auto found = std::ranges::find(whole.axes, substance, &WholeSurface::Axes::substance);
    return found != whole.axes.end() ? found->frame.scale
                                     : mean_radius(mesh, whole.moments.of(substance).centroid);
}

} // namespace

WholeSurface look_at_whole(const TriangleMesh& mesh) {
    WholeSurface whole{shape_moments(mesh), {}, {}};
    for (const Substance substance : whole.moments.possible_substances())
        whole.axes.push_back({substance, principal_frame(mesh, whole.moments.of(substance)), {}});
    parallel_invoke(
        [&] { whole.outline = search::outline(mesh, whole.moments, outline_radius(mesh, whole)); },
        [&] {
            for (WholeSurface::Axes& axes : whole.axes)
                axes.before_smoothing = resync::frames_before_smoothing(mesh, axes.frame, axes.substance);
        });
    return whole;
}

std::shared_ptr<const WholeSurface> Suspect::whole_surface() const {
    return whole ? whole : std::make_shared<const WholeSurface>(look_at_whole(mesh));
}

Suspect simplify_suspect(const TriangleMesh& mesh, std::size_t vertices, const Progress& progress) {
    simplify::Options options;
    options.target_vertices = vertices;
    simplify::Result simplified = simplify::simplify(mesh, options, progress);
    LargestParts parts = largest_parts(std::move(simplified.mesh), std::max(vertices, most_base_vertices));
    return {mesh, std::move(parts.mesh), simplified.stop, parts.telling};
}

Suspect prepare_suspect(const TriangleMesh& mesh, std::size_t vertices, const Progress& progress) {
    std::shared_ptr<const WholeSurface> whole;
    std::optional<Suspect> suspect;
    const auto look = [&] { whole = std::make_shared<const WholeSurface>(look_at_whole(mesh)); };
    const auto simplify = [&] { suspect.emplace(simplify_suspect(mesh, vertices, progress)); };
    if (mesh.triangles.size() <= small_beside_memory) {
        parallel_invoke(look, simplify);
    } else {
        look();
        simplify();
    }
    suspect->whole = std::move(whole);
    return *std::move(suspect);
}

} // namespace wm3d::watermark
