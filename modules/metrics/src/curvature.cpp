// SPDX-License-Identifier: GPL-3.0-or-later
#include "curvature.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>

#include <wm3d/core/parallel.hpp>

namespace wm3d::metrics {

namespace {

constexpr std::size_t block = 16384; // large: every block has its own marks for all vertices

/// Length of segment p-q inside the sphere. \pre  p is inside
double length_inside(const Vec3& p, const Vec3& q, const Vec3& centre, double radius) {
    const Vec3 d = q - p, m = p - centre;
    const double a = d.squaredNorm();
    if (!(a > 0))
        return 0;
    // |m + t d| = radius, the root ahead
    const double b = m.dot(d), c = m.squaredNorm() - radius * radius;
    const double t = (-b + std::sqrt(std::max(0.0, b * b - a * c))) / a;
    return std::sqrt(a) * std::clamp(t, 0.0, 1.0);
}

Mat3 tensor_at(const TriangleMesh& mesh, const VertexAdjacency& adjacency, BallWalk& walk, Index vertex,
               double radius) {
    Mat3 tensor = Mat3::Zero();
    for (Index v : walk.gather(vertex, radius))
        for (Index e : adjacency.edges_at(v)) {
            const Index w = adjacency.other_end(e, v);
            if (walk.contains(w) && w < v)
                continue; // counted at its other end
            const Vec3& p = mesh.positions[v];
            const Vec3& q = mesh.positions[w];
            const double length = length_inside(p, q, mesh.positions[vertex], radius);
            if (!(length > 0))
                continue;
            const Vec3 direction = (q - p).normalized();
            tensor += adjacency.edges()[e].angle * length * direction * direction.transpose();
        }
    return tensor / (std::numbers::pi * radius * radius);
}

} // namespace

std::vector<double> curvature_magnitude(const TriangleMesh& mesh, const VertexAdjacency& adjacency,
                                        double radius) {
    std::vector<double> curvature(mesh.positions.size(), 0.0);
    parallel_blocks(curvature.size(), block, [&](std::size_t begin, std::size_t end) {
        BallWalk walk(mesh, adjacency);
        for (std::size_t v = begin; v < end; ++v) {
            const Mat3 tensor = tensor_at(mesh, adjacency, walk, static_cast<Index>(v), radius);
            const Eigen::SelfAdjointEigenSolver<Mat3> eigen(tensor, Eigen::EigenvaluesOnly);
            const Vec3 magnitudes = eigen.eigenvalues().cwiseAbs();
            curvature[v] = (magnitudes.sum() - magnitudes.minCoeff()) / 2;
        }
    });
    return curvature;
}

} // namespace wm3d::metrics
