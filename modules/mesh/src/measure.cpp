// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/mesh/measure.hpp>

#include <algorithm>

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
    const auto box_of = [&](std::size_t begin, std::size_t end) {
        const Vec3& start = mesh.positions[mesh.triangles[begin][0]];
        Box box{start, start};
        for (std::size_t f = begin; f < end; ++f)
            for (Index v : mesh.triangles[f])
                extend(box, mesh.positions[v]);
        return box;
    };
    std::vector<Box> parts((mesh.triangles.size() + measure_block - 1) / measure_block);
    parallel_blocks(mesh.triangles.size(), measure_block, [&](std::size_t begin, std::size_t end) {
        parts[begin / measure_block] = box_of(begin, end);
    });
    Box box = parts.front();
    for (const Box& part : parts) {
        extend(box, part.min);
        extend(box, part.max);
    }
    return box;
}

std::vector<double> triangle_areas(const TriangleMesh& mesh) {
    std::vector<double> areas(mesh.triangles.size());
    parallel_blocks(areas.size(), measure_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f)
            areas[f] = triangle_area(mesh, f);
    });
    return areas;
}

std::vector<double> vertex_areas(const TriangleMesh& mesh) {
    const std::vector<double> of_triangle = triangle_areas(mesh);
    std::vector<double> areas(mesh.positions.size(), 0.0);
    parallel_shares(areas.size(), of_triangle.size(), [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = 0; f < of_triangle.size(); ++f) {
            const double third = of_triangle[f] / 3;
            for (Index v : mesh.triangles[f])
                if (v >= begin && v < end)
                    areas[v] += third;
        }
    });
    return areas;
}

std::vector<Vec3> vertex_normals(const TriangleMesh& mesh) {
    std::vector<Vec3> normals(mesh.positions.size(), Vec3::Zero());
    parallel_shares(normals.size(), mesh.triangles.size(), [&](std::size_t begin, std::size_t end) {
        const auto is_own = [&](Index v) { return v >= begin && v < end; };
        for (std::size_t f = 0; f < mesh.triangles.size(); ++f) {
            if (std::ranges::none_of(mesh.triangles[f], is_own))
                continue;
            const Vec3 weighted = area_vector(mesh, f);
            for (Index v : mesh.triangles[f])
                if (is_own(v))
                    normals[v] += weighted;
        }
        for (std::size_t v = begin; v < end; ++v)
            if (const double length = normals[v].norm(); length > 0)
                normals[v] /= length;
    });
    return normals;
}

double surface_area(const TriangleMesh& mesh) {
    return parallel_sum_of(mesh.triangles.size(), measure_block,
                           [&](std::size_t f) { return triangle_area(mesh, f); });
}

} // namespace wm3d
