// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_contact.hpp"

#include <algorithm>
#include <tuple>

#include <wm3d/mesh/measure.hpp>

namespace wm3d::resync {

namespace {

std::vector<std::array<bool, 3>> border_edges(const TriangleMesh& mesh) {
    struct Edge {
        Index low, high, face, corner;
    };
    std::vector<Edge> edges;
    edges.reserve(3 * mesh.triangles.size());
    for (Index f = 0; f < mesh.triangles.size(); ++f)
        for (Index k = 0; k < 3; ++k) {
            const auto [low, high] =
                std::minmax(mesh.triangles[f][(k + 1) % 3], mesh.triangles[f][(k + 2) % 3]);
            edges.push_back({low, high, f, k});
        }
    const auto ends = [](const Edge& e) { return std::tie(e.low, e.high); };
    std::ranges::sort(edges, [&](const Edge& a, const Edge& b) { return ends(a) < ends(b); });
    std::vector<std::array<bool, 3>> border(mesh.triangles.size(), {false, false, false});
    for (std::size_t e = 0; e < edges.size(); ++e) {
        const bool before = e > 0 && ends(edges[e - 1]) == ends(edges[e]);
        const bool after = e + 1 < edges.size() && ends(edges[e + 1]) == ends(edges[e]);
        border[edges[e].face][edges[e].corner] = !before && !after;
    }
    return border;
}

} // namespace

ContactSurface::ContactSurface(const TriangleMesh& mesh)
    : mesh_(mesh), tree_(mesh), normals_(vertex_normals(mesh)), border_(border_edges(mesh)) {}

std::optional<Contact> ContactSurface::contact(const Vec3& query) const {
    const metrics::ClosestPoint closest = tree_.closest(query);
    if (on_border(closest.at))
        return std::nullopt;
    const Triangle& t = mesh_.triangles[closest.at.triangle];
    const Vec3& b = closest.at.barycentric;
    const Vec3 blended = b[0] * normals_[t[0]] + b[1] * normals_[t[1]] + b[2] * normals_[t[2]];
    const Vec3 flat = area_vector(mesh_, closest.at.triangle).normalized();
    // At a crease the blend says little about either side.
    const Vec3 normal = blended.norm() > 0.5 ? Vec3(blended.normalized()) : flat;
    return Contact{closest.position, normal, closest.distance};
}

bool ContactSurface::on_border(const SurfacePoint& at) const {
    constexpr double on_edge = 1e-6;
    for (int k = 0; k < 3; ++k)
        if (border_[at.triangle][static_cast<std::size_t>(k)] && at.barycentric[k] < on_edge)
            return true;
    return false;
}

} // namespace wm3d::resync
