// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/attack/deformation.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <wm3d/attack/random.hpp>
#include <wm3d/core/error.hpp>
#include <wm3d/core/parallel.hpp>
#include <wm3d/mesh/centre.hpp>
#include <wm3d/mesh/measure.hpp>

namespace wm3d::attack {

namespace {

/// p -> matrix (p - centre) + target
TriangleMesh affine(const TriangleMesh& mesh, const Mat3& matrix, const Vec3& centre, const Vec3& target) {
    TriangleMesh result = mesh;
    parallel_blocks(result.positions.size(), 16384, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v)
            result.positions[v] = matrix * (mesh.positions[v] - centre) + target;
    });
    return result;
}

/// Axes of the box from its longest to its shortest side.
std::array<int, 3> sorted_axes(const Box& box) {
    const Vec3 size = box.max - box.min;
    std::array<int, 3> axes{0, 1, 2};
    std::stable_sort(axes.begin(), axes.end(), [&](int a, int b) { return size[a] > size[b]; });
    return axes;
}

} // namespace

Similarity random_similarity(double d, std::uint64_t seed) {
    const RandomStream random(seed, 0);
    Similarity similarity;
    for (std::uint64_t k = 0; k < 3; ++k)
        similarity.translation[static_cast<int>(k)] = random.between(k, -5 * d, 5 * d);
    // Archimedes: height and longitude of a uniform direction are independent and uniform.
    const double height = random.between(3, -1, 1);
    const double longitude = random.between(4, 0, 2 * std::numbers::pi);
    const double radius = std::sqrt(1 - height * height);
    const Vec3 axis{radius * std::cos(longitude), radius * std::sin(longitude), height};
    const double angle = random.between(5, 0, 2 * std::numbers::pi);
    similarity.rotation = Eigen::AngleAxisd(angle, axis).toRotationMatrix();
    similarity.scale = random.between(6, 0.1, 10);
    return similarity;
}

TriangleMesh transform(const TriangleMesh& mesh, const Similarity& similarity) {
    if (mesh.positions.empty())
        return mesh;
    const Vec3 centre = vertex_mean(mesh);
    return affine(mesh, similarity.scale * similarity.rotation, centre, centre + similarity.translation);
}

TriangleMesh transform(const TriangleMesh& mesh, const Mat3& matrix) {
    if (!(std::abs(matrix.determinant()) > 0))
        throw ParameterError("the linear map is singular, so it would flatten the model; give scale factors "
                             "other than 0");
    if (mesh.positions.empty())
        return mesh;
    const Vec3 centre = vertex_mean(mesh);
    return affine(mesh, matrix, centre, centre);
}

TriangleMesh bend(const TriangleMesh& mesh, double degrees) {
    if (degrees == 0)
        return mesh;
    const Box box = surface_box(mesh);
    const Vec3 centre = 0.5 * (box.min + box.max);
    const auto [along, towards, across] = sorted_axes(box);
    const double angle = degrees * std::numbers::pi / 180;
    const double radius = (box.max - box.min)[along] / angle; // of the arc that the middle line becomes

    TriangleMesh result = mesh;
    for (Vec3& p : result.positions) {
        const double turn = (p[along] - centre[along]) / radius;
        const double to_axis = radius - (p[towards] - centre[towards]);
        p[along] = centre[along] + to_axis * std::sin(turn);
        p[towards] = centre[towards] + radius - to_axis * std::cos(turn);
    }
    (void)across; // unmoved
    return result;
}

} // namespace wm3d::attack
