// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/simplify/simplify.hpp>

#include <algorithm>
#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <wm3d/core/error.hpp>

#include "canonical.hpp"
#include "decimator.hpp"
#include "thinning.hpp"

namespace wm3d::simplify {

namespace {

void check(const Options& options) {
    if (!(options.boundary_weight >= 0) || !std::isfinite(options.boundary_weight))
        throw ParameterError(
            fmt::format("the boundary weight is {}, but it must be a finite number of at least 0",
                        options.boundary_weight));
    if (!(options.isotropy >= 0) || !std::isfinite(options.isotropy))
        throw ParameterError(fmt::format("the isotropy is {}, but it must be a finite number of at least 0",
                                         options.isotropy));
    if (!(options.max_normal_turn >= 0 && options.max_normal_turn <= 90))
        throw ParameterError(
            fmt::format("the largest turn of a normal is {} degrees, but it must be between 0 and 90",
                        options.max_normal_turn));
}

/// The numbers of working vertices in the base mesh: those that live, the copies of one vertex as one.
struct Numbering {
    std::vector<Index> base_vertex; ///< #W
    std::vector<Index> kept;        ///< #base vertices: working vertices
};

Numbering number_survivors(const Rings& rings, const std::vector<Index>& source) {
    Numbering numbering;
    numbering.base_vertex.assign(rings.size(), no_index);
    for (Index w = 0; w < rings.size(); ++w) {
        if (!rings.alive(w))
            continue;
        if (source[w] == w) {
            numbering.base_vertex[w] = static_cast<Index>(numbering.kept.size());
            numbering.kept.push_back(w);
        } else { // a copy; copies follow all others
            numbering.base_vertex[w] = numbering.base_vertex[source[w]];
        }
    }
    return numbering;
}

/// The triangles that live, in the order of their faces.
/// \param faces  receives the working face of each.
std::vector<Triangle> surviving_triangles(const Rings& rings, const std::vector<Index>& base_vertex,
                                          std::size_t face_count, std::vector<Index>& faces) {
    std::vector<Index> corners(3 * face_count, no_index);
    for (Index w = 0; w < rings.size(); ++w)
        for (const Spoke& s : rings.of(w))
            if (s.corner != no_index)
                corners[s.corner] = base_vertex[w];
    std::vector<Triangle> surviving;
    for (Index f = 0; f < face_count; ++f)
        if (const std::size_t c = 3 * std::size_t{f}; corners[c] != no_index) {
            surviving.push_back({corners[c], corners[c + 1], corners[c + 2]});
            faces.push_back(f);
        }
    return surviving;
}

/// What an observer is shown: copies of the vertices and corners as they are before the first collapse.
struct Snapshot {
    std::vector<Vec3> positions;
    std::vector<Index> corners, input_vertex;

    Snapshot(const std::vector<Index>& numbers, const Surface& surface, const Sites& sites, std::size_t faces)
        : corners(3 * faces) {
        positions.reserve(surface.source.size());
        input_vertex.reserve(surface.source.size());
        for (Index w = 0; w < surface.source.size(); ++w) {
            positions.push_back(sites.site[w].position);
            input_vertex.push_back(numbers[surface.source[w]]);
            for (const Spoke& s : surface.rings.of(w))
                if (s.corner != no_index)
                    corners[s.corner] = w;
        }
    }
};

/// Everything the simplification works on.
struct Workplace {
    std::vector<Index> input_vertex; ///< #vertices: their numbers in the input
    double scale = 1;                ///< units of the input per unit of the sites
    std::size_t faces = 0;
    Surface surface;
    Sites sites;
    std::size_t removed = 0;  ///< vertices, by thinning
    double largest_error = 0; ///< of it
};

bool is_dense(const Canonical& mesh, const Options& options) {
    constexpr std::size_t much_more = 8; // than what will be left
    return mesh.positions.size() >= options.thinned_from &&
           mesh.positions.size() / much_more >= options.target_vertices;
}

/// \param may_thin  collapses needn't come in the order of their costs over all of the mesh
Workplace prepare(const TriangleMesh& mesh, const Options& options, bool may_thin) {
    Canonical input = canonical_order(mesh);
    Thinning thinned;
    if (may_thin && is_dense(input, options)) {
        thinned = thin(input, options);
        thin_further(input, options, thinned);
    }
    const std::size_t faces = input.triangles.size();
    Surface surface = build_surface(std::exchange(input.triangles, {}), input.positions);
    Sites sites = build_sites(surface, std::move(input.positions), options, thinned.standing);
    return {std::move(input.input_vertex),
            input.scale,
            faces,
            std::move(surface),
            std::move(sites),
            thinned.removed,
            thinned.largest_error};
}

Result run(const TriangleMesh& mesh, const Options& options, Observer* observer, const Progress& progress) {
    check(options);
    notify(progress, "simplify", 0);
    Workplace work = prepare(mesh, options, observer == nullptr);
    std::optional<Snapshot> snapshot;
    if (observer) {
        snapshot.emplace(work.input_vertex, work.surface, work.sites, work.faces);
        observer->start({snapshot->positions, snapshot->corners, snapshot->input_vertex});
    }
    Result result;
    const std::size_t vertices = work.input_vertex.size();
    if (vertices <= options.target_vertices) {
        result.stop = Stop::already_small;
    } else {
        Decimator decimator(work.surface.rings, work.sites, options, observer);
        const std::size_t removed = decimator.remove(vertices - options.target_vertices, progress);
        result.collapses = work.removed + removed;
        result.error = std::sqrt(std::max(work.largest_error, decimator.largest_error())) * work.scale;
        result.stop = vertices - removed == options.target_vertices ? Stop::reached : Stop::blocked;
    }
    const Numbering numbering = number_survivors(work.surface.rings, work.surface.source);
    std::vector<Index> faces;
    result.mesh.triangles = surviving_triangles(work.surface.rings, numbering.base_vertex, work.faces, faces);
    for (Index w : numbering.kept) {
        result.original.push_back(work.input_vertex[w]);
        result.mesh.positions.push_back(mesh.positions[result.original.back()]);
    }
    if (observer)
        observer->finish(faces);
    notify(progress, "simplify", 1);
    return result;
}

} // namespace

std::string_view describe(Stop stop) {
    switch (stop) {
    case Stop::reached:
        return "the base mesh has the number of vertices asked for";
    case Stop::already_small:
        return "the mesh has no more vertices than were asked for, so none was removed";
    case Stop::blocked:
        return "no further vertex can go without changing the topology, a boundary or the side of a triangle";
    }
    return "";
}

Result simplify(const TriangleMesh& mesh, const Options& options, const Progress& progress) {
    return run(mesh, options, nullptr, progress);
}

Result simplify(const TriangleMesh& mesh, const Options& options, Observer& observer,
                const Progress& progress) {
    return run(mesh, options, &observer, progress);
}

} // namespace wm3d::simplify
