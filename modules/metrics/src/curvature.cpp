// SPDX-License-Identifier: GPL-3.0-or-later
#include "curvature.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

#include <Eigen/Eigenvalues>

#include <wm3d/core/parallel.hpp>

#include "outward_walk.hpp"

namespace wm3d::metrics {

namespace {

using Symmetric = std::array<double, 6>; // xx, xy, xz, yy, yz, zz

/// (|k1| + |k2|) / 2 of a tensor whose third eigenvalue, the least in magnitude, is the normal's.
double magnitude(const Symmetric& s) {
    Mat3 tensor;
    tensor << s[0], s[1], s[2], s[1], s[3], s[4], s[2], s[4], s[5];
    Eigen::SelfAdjointEigenSolver<Mat3> eigen;
    eigen.computeDirect(tensor,
                        Eigen::EigenvaluesOnly); // closed form: iterations would take longer than the walk
    const Vec3 magnitudes = eigen.eigenvalues().cwiseAbs();
    return (magnitudes.sum() - magnitudes.minCoeff()) / 2;
}

/// angle(e) / length(e), which makes angle(e) length(e) e e^T of a unit e that of the whole edge, #E.
std::vector<double> edge_weights(const TriangleMesh& mesh, const EdgeGraph& graph,
                                 const std::vector<double>& angles) {
    const std::span<const EdgeGraph::Edge> edges = graph.edges();
    std::vector<double> weights(edges.size(), 0.0);
    parallel_blocks(edges.size(), 8192, [&](std::size_t begin, std::size_t end) {
        for (std::size_t e = begin; e < end; ++e)
            if (angles[e] != 0)
                weights[e] = angles[e] / (mesh.positions[edges[e].b] - mesh.positions[edges[e].a]).norm();
    });
    return weights;
}

} // namespace

std::vector<PerScale> curvature_magnitudes(const TriangleMesh& mesh, const EdgeGraph& graph,
                                           const std::vector<double>& angles, const PerScale& radii,
                                           std::span<const char> wanted) {
    const double largest = *std::ranges::max_element(radii);
    const std::size_t count = mesh.positions.size();
    const std::vector<double> weights = edge_weights(mesh, graph, angles);
    std::vector<PerScale> curvature(count, PerScale{});
    parallel_blocks(count, walk_block(count), [&](std::size_t begin, std::size_t end) {
        OutwardWalk walk(mesh, graph);
        for (std::size_t v = begin; v < end; ++v) {
            if (!wanted.empty() && !wanted[v])
                continue;
            std::array<Symmetric, std::tuple_size_v<PerScale>> tensors{};
            const auto add = [&](const OutwardStep& s) {
                const double weight = weights[s.edge];
                if (weight == 0)
                    return;
                const Vec3& e = s.along;
                const Symmetric whole{weight * e[0] * e[0], weight * e[0] * e[1], weight * e[0] * e[2],
                                      weight * e[1] * e[1], weight * e[1] * e[2], weight * e[2] * e[2]};
                for (std::size_t k = 0; k < radii.size(); ++k)
                    if (s.starts_within(radii[k])) {
                        const double share = s.share_within(radii[k]);
                        for (std::size_t i = 0; i < whole.size(); ++i)
                            tensors[k][i] += share * whole[i];
                    }
            };
            walk.from(
                static_cast<Index>(v), largest, [](Index, double) {}, add);
            for (std::size_t k = 0; k < radii.size(); ++k)
                curvature[v][k] = magnitude(tensors[k]) / (std::numbers::pi * radii[k] * radii[k]);
        }
    });
    return curvature;
}

} // namespace wm3d::metrics
