// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/simplify/simplify.hpp>

#include <cmath>
#include <optional>
#include <utility>

#include <fmt/format.h>
#include <wm3d/mesh/error.hpp>

#include "canonical.hpp"
#include "decimator.hpp"

namespace wm3d::simplify {

namespace {

void check(const Options& options) {
    if (!(options.boundary_weight >= 0) || !std::isfinite(options.boundary_weight))
        throw ParameterError(fmt::format("the boundary weight is {}, but it must be a finite number of at least 0",
                                         options.boundary_weight));
    if (!(options.isotropy >= 0) || !std::isfinite(options.isotropy))
        throw ParameterError(
            fmt::format("the isotropy is {}, but it must be a finite number of at least 0", options.isotropy));
    if (!(options.max_normal_turn >= 0 && options.max_normal_turn <= 90))
        throw ParameterError(fmt::format("the largest turn of a normal is {} degrees, but it must be between 0 and 90",
                                         options.max_normal_turn));
}

/// The numbers of working vertices in the base mesh: those that live, the copies of one vertex as one.
struct Numbering {
    std::vector<Index> base_vertex; ///< #W
    std::vector<Index> kept;        ///< #base vertices: working vertices
};

Numbering number_survivors(const HalfEdges& mesh) {
    Numbering numbering;
    numbering.base_vertex.assign(mesh.leaving.size(), no_index);
    for (Index w = 0; w < mesh.leaving.size(); ++w) {
        if (mesh.leaving[w] == no_index)
            continue;
        const Index source = mesh.source[w]; // never greater than w, so numbered before its copies
        if (source == w) {
            numbering.base_vertex[w] = static_cast<Index>(numbering.kept.size());
            numbering.kept.push_back(w);
        } else {
            numbering.base_vertex[w] = numbering.base_vertex[source];
        }
    }
    return numbering;
}

/// Fills mesh and original; returns the working face of each triangle.
std::vector<Index> extract(const TriangleMesh& input, const HalfEdges& mesh, const std::vector<Index>& input_vertex,
                           const Numbering& numbering, Result& result) {
    for (Index w : numbering.kept) {
        result.original.push_back(input_vertex[w]);
        result.mesh.positions.push_back(input.positions[input_vertex[w]]);
    }
    std::vector<Index> faces;
    for (Index h = 0; h < mesh.edges.size(); h += 3) {
        if (mesh.edges[h].origin == no_index)
            continue;
        result.mesh.triangles.push_back({numbering.base_vertex[mesh.edges[h].origin],
                                         numbering.base_vertex[mesh.edges[h + 1].origin],
                                         numbering.base_vertex[mesh.edges[h + 2].origin]});
        faces.push_back(h / 3);
    }
    return faces;
}

/// What an observer is shown: copies of the vertices and corners as they are before the first collapse.
struct Snapshot {
    std::vector<Vec3> positions;
    std::vector<Index> corners, input_vertex;

    Snapshot(const HalfEdges& mesh, const Canonical& input) {
        for (Index source : mesh.source) {
            positions.push_back(input.positions[source]);
            input_vertex.push_back(input.input_vertex[source]);
        }
        for (const HalfEdge& edge : mesh.edges)
            corners.push_back(edge.origin);
    }
};

Result run(const TriangleMesh& mesh, const Options& options, Observer* observer, const Progress& progress) {
    check(options);
    report(progress, "simplify", 0);
    Canonical input = canonical_order(mesh);
    const std::size_t vertices = input.positions.size();
    HalfEdges half_edges = build_half_edges(std::exchange(input.triangles, {}), input.positions);
    Sites sites = build_sites(half_edges, input.positions, options);

    std::optional<Snapshot> snapshot;
    if (observer) {
        snapshot.emplace(half_edges, input);
        observer->start({snapshot->positions, snapshot->corners, snapshot->input_vertex});
    }
    Result result;
    if (vertices <= options.target_vertices) {
        result.stop = Stop::already_small;
    } else {
        Decimator decimator(half_edges, sites, options, observer);
        result.collapses = decimator.remove(vertices - options.target_vertices, progress);
        result.error = std::sqrt(decimator.largest_error()) * input.scale;
        result.stop = vertices - result.collapses == options.target_vertices ? Stop::reached : Stop::blocked;
    }
    const Numbering numbering = number_survivors(half_edges);
    const std::vector<Index> faces = extract(mesh, half_edges, input.input_vertex, numbering, result);
    if (observer)
        observer->finish(faces);
    report(progress, "simplify", 1);
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

Result simplify(const TriangleMesh& mesh, const Options& options, Observer& observer, const Progress& progress) {
    return run(mesh, options, &observer, progress);
}

} // namespace wm3d::simplify
