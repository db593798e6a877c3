// SPDX-License-Identifier: GPL-3.0-or-later
#include "sites.hpp"

#include <cmath>

#include <wm3d/mesh/parallel.hpp>
#include <wm3d/simplify/simplify.hpp>

namespace wm3d::simplify {

namespace {

constexpr std::size_t block = 4096;

Kind kind_of(const HalfEdges& mesh, Index v) {
    if (mesh.locked[v])
        return Kind::locked;
    return mesh.boundary(v) ? Kind::boundary : Kind::interior;
}

/// Twice the area times the unit normal of the triangle of h.
Vec3 area_vector(const HalfEdges& mesh, const std::vector<Site>& site, Index h) {
    const Vec3& a = site[mesh.edges[h].origin].position;
    const Vec3& b = site[mesh.edges[next(h)].origin].position;
    const Vec3& c = site[mesh.edges[previous(h)].origin].position;
    return (b - a).cross(c - a);
}

/// Plane through boundary edge h, perpendicular to its triangle; weight: the edge's squared length.
void add_boundary_plane(const HalfEdges& mesh, const std::vector<Site>& site, Index h, double weight, Quadric& q) {
    const Vec3 normal = area_vector(mesh, site, h);
    const double length = normal.norm();
    if (!(length > 0))
        return;
    const Vec3 edge = site[mesh.target(h)].position - site[mesh.edges[h].origin].position;
    q.add_plane(std::sqrt(weight) / length * edge.cross(normal));
}

Quadric initial_quadric(const HalfEdges& mesh, const std::vector<Site>& site, Index v, const Options& options) {
    Quadric q;
    const Index start = mesh.leaving[v];
    for (Index h = start, last = h;;) {
        const Vec3 n = area_vector(mesh, site, h);
        if (const double length = n.norm(); length > 0) {
            q.add_plane(n * std::sqrt(0.5 / length));
            q.add_point(0.5 * length * options.isotropy);
        }
        last = h;
        h = mesh.turn(h);
        if (h == start)
            break;
        if (h == no_index) {
            add_boundary_plane(mesh, site, start, options.boundary_weight, q);
            add_boundary_plane(mesh, site, previous(last), options.boundary_weight, q);
            break;
        }
    }
    return q;
}

} // namespace

Sites build_sites(const HalfEdges& mesh, const std::vector<Vec3>& positions, const Options& options) {
    Sites out;
    const std::size_t count = mesh.leaving.size();
    out.site.resize(count);
    out.quadric.resize(count);
    out.kind.resize(count);
    for (std::size_t v = 0; v < count; ++v)
        out.site[v].position = positions[mesh.source[v]];
    parallel_blocks(count, block, [&](std::size_t begin, std::size_t end) {
        for (auto v = static_cast<Index>(begin); v < end; ++v) {
            out.quadric[v] = initial_quadric(mesh, out.site, v, options);
            out.kind[v] = kind_of(mesh, v);
        }
    });
    return out;
}

} // namespace wm3d::simplify
