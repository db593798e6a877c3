// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/metrics/surface_distance.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <wm3d/core/parallel.hpp>
#include <wm3d/mesh/measure.hpp>

namespace wm3d::metrics {

namespace {

constexpr std::size_t block = 512;
constexpr double most_parts = 4096; // of a side of one triangle

struct Sums {
    double weight = 0, distance = 0, square = 0, max = 0, angle = 0;
    std::size_t samples = 0;

    Sums& operator+=(const Sums& o) {
        weight += o.weight;
        distance += o.distance;
        square += o.square;
        max = std::max(max, o.max);
        angle += o.angle;
        samples += o.samples;
        return *this;
    }
};

/// Calls visit(barycentric) at the centre of each of the m^2 like parts of a triangle.
template<typename Visit>
void for_each_part(std::size_t m, Visit&& visit) {
    const auto centre = [&](std::size_t i, std::size_t j, double third) {
        const double u = (static_cast<double>(i) + third) / static_cast<double>(m);
        const double v = (static_cast<double>(j) + third) / static_cast<double>(m);
        visit(Vec3(1 - u - v, u, v));
    };
    for (std::size_t i = 0; i < m; ++i)
        for (std::size_t j = 0; i + j < m; ++j) {
            centre(i, j, 1.0 / 3);
            if (i + j + 1 < m)
                centre(i, j, 2.0 / 3); // the part that stands on its head
        }
}

/// Angle between two area vectors in degrees; 0 if one vanishes.
double angle_between(const Vec3& a, const Vec3& b) {
    return std::atan2(a.cross(b).norm(), a.dot(b)) * 180 / std::numbers::pi;
}

/// Distances of the samples in triangle f.
/// \param near  a triangle to look at first; then the last one found
void add_triangle(const TriangleMesh& from, std::size_t f, const SurfaceTree& to, double density, Index& near,
                  Sums& sums) {
    const Vec3 normal = area_vector(from, f);
    const double area = 0.5 * normal.norm();
    if (!(area > 0))
        return;
    const auto m =
        static_cast<std::size_t>(std::clamp(std::ceil(std::sqrt(area * density)), 1.0, most_parts));
    const double weight = area / static_cast<double>(m * m);
    for_each_part(m, [&](const Vec3& barycentric) {
        const ClosestPoint closest = to.closest(evaluate(from, {static_cast<Index>(f), barycentric}), near);
        near = closest.at.triangle;
        sums.weight += weight;
        sums.distance += weight * closest.distance;
        sums.square += weight * closest.distance * closest.distance;
        sums.max = std::max(sums.max, closest.distance);
        sums.angle += weight * angle_between(normal, area_vector(to.mesh(), closest.at.triangle));
        ++sums.samples;
    });
}

/// Whether each vertex belongs to a triangle, #V.
std::vector<char> used_vertices(const TriangleMesh& mesh) {
    std::vector<char> used(mesh.positions.size(), 0);
    for (const Triangle& t : mesh.triangles)
        for (Index v : t)
            used[v] = 1;
    return used;
}

} // namespace

OneSidedDistance surface_distance(const TriangleMesh& from, const SurfaceTree& to, std::size_t samples) {
    const double area = surface_area(from);
    const double density = area > 0 ? static_cast<double>(samples) / area : 0;
    // A triangle that moved a little is the one to look at first; else triangles of successive numbers are
    // mostly close.
    const bool same_triangles = from.triangles == to.mesh().triangles;
    const Sums sums =
        parallel_sum(from.triangles.size(), block, Sums{}, [&](std::size_t begin, std::size_t end) {
            Sums part;
            Index near = 0;
            for (std::size_t f = begin; f < end; ++f) {
                if (same_triangles)
                    near = static_cast<Index>(f);
                add_triangle(from, f, to, density, near, part);
            }
            return part;
        });
    OneSidedDistance distance;
    if (sums.samples == 0)
        return distance;
    distance.mean = sums.distance / sums.weight;
    distance.rms = std::sqrt(sums.square / sums.weight);
    distance.normal_deviation = sums.angle / sums.weight;
    distance.samples = sums.samples;
    distance.spacing = std::sqrt(area / static_cast<double>(sums.samples));

    const std::vector<double> at_vertices = vertex_distances(from, to);
    const std::vector<char> used = used_vertices(from);
    distance.max = sums.max;
    for (std::size_t v = 0; v < at_vertices.size(); ++v)
        if (used[v])
            distance.max = std::max(distance.max, at_vertices[v]);
    return distance;
}

std::vector<double> vertex_distances(const TriangleMesh& mesh, const SurfaceTree& reference) {
    std::vector<double> distances(mesh.positions.size());
    parallel_blocks(distances.size(), block, [&](std::size_t begin, std::size_t end) {
        Index near = 0; // then the last one found: vertices of successive numbers are mostly close
        for (std::size_t v = begin; v < end; ++v) {
            const ClosestPoint closest = reference.closest(mesh.positions[v], near);
            near = closest.at.triangle;
            distances[v] = closest.distance;
        }
    });
    return distances;
}

} // namespace wm3d::metrics
