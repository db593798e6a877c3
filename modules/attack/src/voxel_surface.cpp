// SPDX-License-Identifier: GPL-3.0-or-later
#include "voxel_surface.hpp"

#include <openvdb/openvdb.h>
#include <openvdb/tools/MeshToVolume.h>
#include <openvdb/tools/VolumeToMesh.h>

void wm3d_extract_surface(std::span<const Eigen::Vector3f> points, std::span<const wm3d::Triangle> triangles,
                          wm3d::attack::VoxelSurface& surface) {
    std::vector<openvdb::Vec3s> places;
    places.reserve(points.size());
    for (const Eigen::Vector3f& p : points)
        places.emplace_back(p[0], p[1], p[2]);
    std::vector<openvdb::Vec3I> corners;
    corners.reserve(triangles.size());
    for (const wm3d::Triangle& t : triangles)
        corners.emplace_back(t[0], t[1], t[2]);

    openvdb::initialize();
    const auto unit = openvdb::math::Transform::createLinearTransform(1.0);
    const auto grid = openvdb::tools::meshToLevelSet<openvdb::FloatGrid>(*unit, places, corners);
    std::vector<openvdb::Vec3s> extracted;
    std::vector<openvdb::Vec4I> quads;
    openvdb::tools::volumeToMesh(*grid, extracted, quads);

    surface.points.reserve(extracted.size());
    for (const openvdb::Vec3s& p : extracted)
        surface.points.emplace_back(p[0], p[1], p[2]);
    surface.quads.reserve(quads.size());
    for (const openvdb::Vec4I& q : quads)
        surface.quads.push_back({q[0], q[1], q[2], q[3]});
}
