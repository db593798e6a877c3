// SPDX-License-Identifier: GPL-3.0-or-later
#include "sites.hpp"

#include <cmath>

#include <wm3d/core/parallel.hpp>
#include <wm3d/simplify/simplify.hpp>

namespace wm3d::simplify {

namespace {

constexpr std::size_t site_block = 4096;

Kind kind_of(const Surface& surface, Index v) {
    if (surface.locked[v])
        return Kind::locked;
    return is_closed(surface.rings.of(v)) ? Kind::interior : Kind::boundary;
}

/// Plane through a boundary edge, perpendicular to its triangle; weight: the edge's squared length.
/// \param normal  of the triangle, of any length
void add_boundary_plane(const Vec3& edge, const Vec3& normal, double weight, Quadric& q) {
    if (const double length = normal.norm(); length > 0)
        q.add_plane(std::sqrt(weight) / length * edge.cross(normal));
}

Quadric initial_quadric(Ring ring, const std::vector<Site>& site, Index v, const Options& options) {
    Quadric q;
    const Vec3& centre = site[v].position;
    const auto edge = [&](std::size_t i) -> Vec3 { return site[ring[i].vertex].position - centre; };
    const bool closed = is_closed(ring);
    const Vec3 first = edge(0);
    Vec3 from = first;
    for (std::size_t i = 0; i + (closed ? 0 : 1) < ring.size(); ++i) {
        const Vec3 to = i + 1 < ring.size() ? edge(i + 1) : first;
        const Vec3 normal = from.cross(to); // twice the area long
        if (const double length = normal.norm(); length > 0) {
            q.add_plane(normal * std::sqrt(0.5 / length));
            q.add_point(0.5 * length * options.isotropy);
        }
        if (!closed && i == 0)
            add_boundary_plane(from, normal, options.boundary_weight, q);
        if (!closed && i + 2 == ring.size())
            add_boundary_plane(to, normal, options.boundary_weight, q);
        from = to;
    }
    return q;
}

} // namespace

Sites build_sites(const Surface& surface, std::vector<Vec3> positions, const Options& options) {
    Sites out;
    const std::size_t count = surface.source.size();
    out.site.resize(count);
    for (std::size_t v = 0; v < count; ++v)
        out.site[v].position = positions[surface.source[v]];
    std::vector<Vec3>().swap(positions);
    out.quadric.resize(count);
    out.kind.resize(count);
    parallel_blocks(count, site_block, [&](std::size_t begin, std::size_t end) {
        for (auto v = static_cast<Index>(begin); v < end; ++v) {
            out.kind[v] = Kind::locked;
            if (!surface.rings.alive(v)) // nothing is known around it
                continue;
            out.quadric[v] = initial_quadric(surface.rings.of(v), out.site, v, options);
            out.kind[v] = kind_of(surface, v);
        }
    });
    return out;
}

} // namespace wm3d::simplify
