// SPDX-License-Identifier: GPL-3.0-or-later
#include "sites.hpp"

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>

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

using Pair = Eigen::Array2d; ///< of two edges or wedges that follow each other

/// The edges of a ring from its centre, by coordinates, so that two are worked on at once.
class Edges {
public:
    void gather(Ring ring, const std::vector<Site>& site, const Vec3& centre) {
        count_ = ring.size();
        closed_ = is_closed(ring);
        for (std::vector<double>& each : coordinates_)
            if (each.size() < count_ + 2)
                each.resize(count_ + 2);
        for (std::size_t i = 0; i < count_ + 2; ++i) { // those behind the last are the first again
            const Vec3 edge = site[ring[i < count_ ? i : 0].vertex].position - centre;
            for (std::size_t k = 0; k < 3; ++k)
                coordinates_[k][i] = edge[static_cast<Eigen::Index>(k)];
        }
    }

    std::size_t count() const { return count_; }
    bool closed() const { return closed_; }
    std::size_t wedges() const { return closed_ ? count_ : count_ - 1; }
    Vec3 at(std::size_t i) const { return {coordinates_[0][i], coordinates_[1][i], coordinates_[2][i]}; }

    std::array<Pair, 3> pair(std::size_t i) const {
        return {Pair::Map(&coordinates_[0][i]), Pair::Map(&coordinates_[1][i]),
                Pair::Map(&coordinates_[2][i])};
    }

private:
    std::array<std::vector<double>, 3> coordinates_;
    std::size_t count_ = 0;
    bool closed_ = false;
};

Quadric initial_quadric(const Edges& edges, const Options& options) {
    Quadric q;
    for (std::size_t i = 0; i < edges.wedges(); i += 2) {
        const auto [ax, ay, az] = edges.pair(i);
        const auto [bx, by, bz] = edges.pair(i + 1);
        const Pair x = ay * bz - az * by, y = az * bx - ax * bz, z = ax * by - ay * bx;
        const Pair length = (x * x + y * y + z * z).sqrt(); // twice the area
        const Pair scale = (0.5 / length).sqrt();
        const Pair mx = x * scale, my = y * scale, mz = z * scale, weight = 0.5 * length * options.isotropy;
        for (std::size_t k = 0; k < std::min<std::size_t>(2, edges.wedges() - i); ++k) {
            const auto lane = static_cast<Eigen::Index>(k);
            if (!(length[lane] > 0))
                continue;
            q.add_plane({mx[lane], my[lane], mz[lane]});
            q.add_point(weight[lane]);
            if (edges.closed())
                continue;
            const std::size_t wedge = i + k;
            const Vec3 normal(x[lane], y[lane], z[lane]);
            if (wedge == 0)
                add_boundary_plane(edges.at(0), normal, options.boundary_weight, q);
            if (wedge + 1 == edges.wedges())
                add_boundary_plane(edges.at(wedge + 1), normal, options.boundary_weight, q);
        }
    }
    return q;
}

/// Quadric::evaluate at the end of the edge where it is least: too low for boundary vertices, whose choices are fewer.
double least_cost(const Edges& edges, const Quadric& q) {
    double least = std::numeric_limits<double>::max();
    for (std::size_t i = 0; i < edges.count(); i += 2) {
        const auto [x, y, z] = edges.pair(i);
        const Pair cost = x * (q.xx * x + q.xy * y + q.xz * z + 2 * q.x) +
                          y * (q.xy * x + q.yy * y + q.yz * z + 2 * q.y) +
                          z * (q.xz * x + q.yz * y + q.zz * z + 2 * q.z);
        least = std::min(std::min(least, cost[0]), cost[1]);
    }
    return least;
}

} // namespace

Sites build_sites(const Surface& surface, std::vector<Vec3> positions, const Options& options,
                  std::span<const Standing> standing, std::size_t first) {
    Sites out;
    const std::size_t count = surface.source.size();
    out.site.resize(count);
    for (std::size_t v = 0; v < count; ++v)
        out.site[v].position = positions[surface.source[v]];
    std::vector<Vec3>().swap(positions);
    out.quadric.resize(count);
    out.kind.resize(count, Kind::locked);
    out.key.resize(count, no_cost);
    parallel_blocks(count, site_block, [&](std::size_t begin, std::size_t end) {
        Edges edges;
        auto inherited = std::ranges::lower_bound(standing, first + begin, {}, &Standing::vertex);
        for (auto v = static_cast<Index>(begin); v < end; ++v) {
            if (!surface.rings.alive(v)) // nothing is known around it
                continue;
            edges.gather(surface.rings.of(v), out.site, out.site[v].position);
            if (inherited != standing.end() && inherited->vertex == first + v) {
                out.quadric[v] = inherited->quadric;
                out.site[v].constant = inherited->constant;
                ++inherited;
            } else {
                out.quadric[v] = initial_quadric(edges, options);
            }
            out.kind[v] = kind_of(surface, v);
            if (out.kind[v] != Kind::locked)
                out.key[v] = cost_key(least_cost(edges, out.quadric[v]));
        }
    });
    return out;
}

} // namespace wm3d::simplify
