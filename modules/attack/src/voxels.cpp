// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/attack/resampling.hpp>

#include <wm3d/core/error.hpp>
#include <wm3d/mesh/measure.hpp>

#include "fan.hpp"
#include "voxel_surface.hpp"

namespace wm3d::attack {

namespace {

/// Cuts a quad, clockwise seen from outside, along its shorter diagonal.
void add_quad(TriangleMesh& mesh, const std::array<Index, 4>& q) {
    const auto length = [&](std::size_t i, std::size_t j) {
        return (mesh.positions[q[i]] - mesh.positions[q[j]]).squaredNorm();
    };
    if (length(0, 2) <= length(1, 3)) {
        mesh.triangles.push_back({q[0], q[2], q[1]});
        mesh.triangles.push_back({q[0], q[3], q[2]});
    } else {
        mesh.triangles.push_back({q[0], q[3], q[1]});
        mesh.triangles.push_back({q[1], q[3], q[2]});
    }
}

} // namespace

bool has_voxels() {
    return true;
}

TriangleMesh extract_voxels(const TriangleMesh& mesh, int resolution) {
    const Box box = surface_box(mesh);
    const double voxel = (box.max - box.min).maxCoeff() / resolution;
    const TriangleMesh closed = close_with_fans(mesh);
    // OpenVDB takes single precision: in voxels from a corner of the box, that is below 1e-4 of a voxel.
    std::vector<Eigen::Vector3f> points;
    points.reserve(closed.positions.size());
    for (const Vec3& p : closed.positions)
        points.emplace_back(((p - box.min) / voxel).cast<float>());
    VoxelSurface surface;
    extract_surface()(points, closed.triangles, surface);
    if (surface.quads.empty())
        throw GeometryError(
            "the model is thinner than the voxels everywhere, so nothing would be left; give a "
            "higher resolution");

    TriangleMesh result;
    result.positions.reserve(surface.points.size());
    for (const Eigen::Vector3f& p : surface.points)
        result.positions.push_back(box.min + voxel * p.cast<double>());
    result.triangles.reserve(2 * surface.quads.size());
    for (const std::array<Index, 4>& q : surface.quads)
        add_quad(result, q);
    return result;
}

} // namespace wm3d::attack
