// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/resync/pose_template.hpp>

#include <algorithm>
#include <cmath>
#include <numeric>

#include <wm3d/core/error.hpp>
#include <wm3d/mesh/measure.hpp>

namespace wm3d::resync {

namespace {

/// Barycentric coordinates of point k of a sequence that covers a triangle evenly (additive recurrence of the
/// plastic number, its square folded onto the triangle).
Vec3 spread(std::size_t k) {
    const double n = static_cast<double>(k + 1);
    double u = std::fmod(0.7548776662466927 * n, 1.0), v = std::fmod(0.5698402909980532 * n, 1.0);
    if (u + v > 1) {
        u = 1 - u;
        v = 1 - v;
    }
    return {1 - u - v, u, v};
}

} // namespace

PoseTemplate make_template(const TriangleMesh& mesh, std::size_t count) {
    if (count == 0)
        throw ParameterError("a pose template needs at least one point");
    std::vector<double> area = triangle_areas(mesh);
    std::partial_sum(area.begin(), area.end(), area.begin());
    if (area.empty() || !(area.back() > 0))
        throw GeometryError(
            "the mesh has no surface area, so there is no pose to remember; check that the file holds "
            "the model that you mean");
    const std::vector<Vec3> vertex_normal = vertex_normals(mesh);
    PoseTemplate result;
    for (std::size_t k = 0; k < count; ++k) {
        const double at = (static_cast<double>(k) + 0.5) / static_cast<double>(count) * area.back();
        const auto f = static_cast<std::size_t>(std::ranges::upper_bound(area, at) - area.begin());
        const Triangle& t = mesh.triangles[f];
        const Vec3 b = spread(k);
        const Vec3 blended =
            b[0] * vertex_normal[t[0]] + b[1] * vertex_normal[t[1]] + b[2] * vertex_normal[t[2]];
        const Vec3 normal = blended.norm() > 0.1 ? blended : area_vector(mesh, f); // opposite corners cancel
        result.points.push_back(b[0] * mesh.positions[t[0]] + b[1] * mesh.positions[t[1]] +
                                b[2] * mesh.positions[t[2]]);
        result.normals.push_back(normal.normalized());
    }
    return result;
}

PoseTemplate moved(const PoseTemplate& pose_template, const Similarity& t) {
    PoseTemplate result = pose_template;
    for (Vec3& p : result.points)
        p = t(p);
    // A mirror image of an outward normal still points outwards.
    for (Vec3& n : result.normals)
        n = t.rotation * n;
    return result;
}

} // namespace wm3d::resync
