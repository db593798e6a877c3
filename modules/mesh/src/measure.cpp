// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/mesh/measure.hpp>

#include <wm3d/core/parallel.hpp>

namespace wm3d {

namespace {

constexpr std::size_t measure_block = 16384;

void extend(Box& box, const Vec3& p) {
    box.min = box.min.cwiseMin(p);
    box.max = box.max.cwiseMax(p);
}

} // namespace

Box bounding_box(std::span<const Vec3> points) {
    if (points.empty())
        return {};
    Box box{points.front(), points.front()};
    for (const Vec3& p : points)
        extend(box, p);
    return box;
}

Box surface_box(const TriangleMesh& mesh) {
    if (mesh.triangles.empty())
        return {};
    const Vec3& start = mesh.positions[mesh.triangles.front()[0]];
    Box box{start, start};
    for (const Triangle& t : mesh.triangles)
        for (Index v : t)
            extend(box, mesh.positions[v]);
    return box;
}

Vec3 area_vector(const TriangleMesh& mesh, std::size_t f) {
    const Triangle& t = mesh.triangles[f];
    const Vec3& a = mesh.positions[t[0]];
    return (mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a);
}

std::vector<double> triangle_areas(const TriangleMesh& mesh) {
    std::vector<double> areas(mesh.triangles.size());
    parallel_blocks(areas.size(), measure_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f)
            areas[f] = 0.5 * area_vector(mesh, f).norm();
    });
    return areas;
}

std::vector<double> vertex_areas(const TriangleMesh& mesh) {
    const std::vector<double> of_triangle = triangle_areas(mesh);
    std::vector<double> areas(mesh.positions.size(), 0.0);
    for (std::size_t f = 0; f < of_triangle.size(); ++f)
        for (Index v : mesh.triangles[f])
            areas[v] += of_triangle[f] / 3;
    return areas;
}

std::vector<Vec3> vertex_normals(const TriangleMesh& mesh) {
    std::vector<Vec3> normals(mesh.positions.size(), Vec3::Zero());
    for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
        const Vec3 weighted = area_vector(mesh, f);
        for (Index v : mesh.triangles[f])
            normals[v] += weighted;
    }
    for (Vec3& n : normals)
        if (const double length = n.norm(); length > 0)
            n /= length;
    return normals;
}

double surface_area(const TriangleMesh& mesh) {
    return parallel_sum_of(mesh.triangles.size(), measure_block,
                           [&](std::size_t f) { return 0.5 * area_vector(mesh, f).norm(); });
}

} // namespace wm3d
