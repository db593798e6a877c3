// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/attack/resampling.hpp>

#include <openvdb/openvdb.h>
#include <openvdb/tools/MeshToVolume.h>
#include <openvdb/tools/VolumeToMesh.h>

#include <wm3d/core/error.hpp>
#include <wm3d/mesh/measure.hpp>

#include "fan.hpp"

namespace wm3d::attack {

namespace {

/// Cuts a quad along its shorter diagonal. OpenVDB winds its faces clockwise seen from outside.
void add_quad(TriangleMesh& mesh, const openvdb::Vec4I& q) {
    const auto length = [&](int i, int j) {
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
    std::vector<openvdb::Vec3s> points;
    points.reserve(closed.positions.size());
    for (const Vec3& p : closed.positions) {
        const Eigen::Vector3f q = ((p - box.min) / voxel).cast<float>();
        points.emplace_back(q[0], q[1], q[2]);
    }
    std::vector<openvdb::Vec3I> triangles;
    triangles.reserve(closed.triangles.size());
    for (const Triangle& t : closed.triangles)
        triangles.emplace_back(t[0], t[1], t[2]);

    openvdb::initialize();
    const auto unit = openvdb::math::Transform::createLinearTransform(1.0);
    const auto grid = openvdb::tools::meshToLevelSet<openvdb::FloatGrid>(*unit, points, triangles);
    std::vector<openvdb::Vec3s> extracted;
    std::vector<openvdb::Vec4I> quads;
    openvdb::tools::volumeToMesh(*grid, extracted, quads);
    if (quads.empty())
        throw GeometryError(
            "the model is thinner than the voxels everywhere, so nothing would be left; give a "
            "higher resolution");

    TriangleMesh result;
    result.positions.reserve(extracted.size());
    for (const openvdb::Vec3s& p : extracted)
        result.positions.push_back(box.min + voxel * Vec3(p[0], p[1], p[2]));
    result.triangles.reserve(2 * quads.size());
    for (const openvdb::Vec4I& q : quads)
        add_quad(result, q);
    return result;
}

} // namespace wm3d::attack
