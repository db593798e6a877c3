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

constexpr std::size_t scales = std::tuple_size_v<PerScale>;

using Symmetric = std::array<double, 6>; // xx, xy, xz, yy, yz, zz

/// (|k1| + |k2|) / 2 of a tensor whose third eigenvalue, the least in magnitude, is the normal's; by the closed form.
double magnitude(const Symmetric& s) {
    Mat3 tensor;
    tensor << s[0], s[1], s[2], s[1], s[3], s[4], s[2], s[4], s[5];
    Eigen::SelfAdjointEigenSolver<Mat3> eigen;
    eigen.computeDirect(tensor, Eigen::EigenvaluesOnly);
    const Vec3 magnitudes = eigen.eigenvalues().cwiseAbs();
    return (magnitudes.sum() - magnitudes.minCoeff()) / 2;
}

using Values = Eigen::Array<double, 4, 1>; // one per scale, and one more to fill two registers

/// The same of three at once. On a surface the normal's eigenvalue is close to 0, so that a few of Newton's steps on the
/// characteristic polynomial reach it from there; where they end elsewhere, the closed form tells.
PerScale magnitudes(const std::array<Symmetric, scales>& tensors) {
    constexpr int steps = 4;
    constexpr double settled = 1e-8; // of the trace; the error is that of its square
    const auto entry = [&](std::size_t i) {
        return Values(tensors[0][i], tensors[1][i], tensors[2][i], tensors[2][i]);
    };
    const Values xx = entry(0), xy = entry(1), xz = entry(2), yy = entry(3), yz = entry(4), zz = entry(5);
    const Values trace = xx + yy + zz;
    const Values minor = yy * zz - yz * yz;
    const Values minors = (xx * yy - xy * xy) + (xx * zz - xz * xz) + minor;
    const Values determinant = xx * minor - xy * (xy * zz - yz * xz) + xz * (xy * yz - yy * xz);
    Values normal = determinant / minors, step;
    for (int k = 1; k < steps; ++k) {
        const Values value = ((normal - trace) * normal + minors) * normal - determinant;
        step = value / ((3 * normal - 2 * trace) * normal + minors);
        normal -= step;
    }
    const Values sum = trace - normal, product = minors - normal * sum;
    const Values difference = (sum * sum - 4 * product).max(0).sqrt(); // of the other two
    const Values largest = (sum.abs() + difference) / 2;
    PerScale result{};
    for (std::size_t k = 0; k < scales; ++k) {
        const auto i = static_cast<Eigen::Index>(k);
        const bool is_least = std::abs(normal[i]) * largest[i] <= std::abs(product[i]);
        if (std::abs(step[i]) <= settled * std::abs(trace[i]) && is_least)
            result[k] = (product[i] >= 0 ? std::abs(sum[i]) : difference[i]) / 2;
        else
            result[k] = magnitude(tensors[k]);
    }
    return result;
}

/// What an edge has to do with a ball.
struct EdgeWeight {
    double tensor = 0;     ///< angle(e) / length(e): angle(e) length(e) e e^T of a unit e, of the whole edge
    double per_square = 0; ///< 1 / length(e)^2
};

std::vector<EdgeWeight> edge_weights(const TriangleMesh& mesh, const EdgeGraph& graph,
                                     const std::vector<double>& angles) {
    const std::span<const EdgeGraph::Edge> edges = graph.edges();
    std::vector<EdgeWeight> weights(edges.size());
    parallel_blocks(edges.size(), 8192, [&](std::size_t begin, std::size_t end) {
        for (std::size_t e = begin; e < end; ++e)
            if (angles[e] != 0) {
                const double square = (mesh.positions[edges[e].b] - mesh.positions[edges[e].a]).squaredNorm();
                weights[e] = {angles[e] / std::sqrt(square), 1 / square};
            }
    });
    return weights;
}

/// The tensors of the balls around a vertex, two edges at a time.
class Balls {
public:
    Balls(const TriangleMesh& mesh, const EdgeGraph& graph, const std::vector<EdgeWeight>& weights,
          const PerScale& radii)
        : weights_(weights), largest_(*std::ranges::max_element(radii)), walk_(mesh, graph) {
        for (std::size_t k = 0; k < scales; ++k)
            squares_[k] = radii[k] * radii[k];
    }

    std::array<Symmetric, scales> tensors(Index centre) {
        walk_.from(centre, largest_);
        for (auto& sum : sums_)
            sum.fill(Pair::Zero());
        const std::span<const OutwardWalk::Step> steps = walk_.steps();
        const OutwardWalk::Step nothing;
        for (std::size_t i = 0; i < steps.size(); i += 2)
            if (i + 1 < steps.size())
                add(steps[i], weights_[steps[i].edge], steps[i + 1], weights_[steps[i + 1].edge]);
            else
                add(steps[i], weights_[steps[i].edge], nothing, {});
        std::array<Symmetric, scales> tensors;
        for (std::size_t k = 0; k < scales; ++k)
            for (std::size_t i = 0; i < tensors[k].size(); ++i)
                tensors[k][i] = sums_[k][i].sum();
        return tensors;
    }

private:
    using Pair = Eigen::Array<double, 2, 1>;

    void add(const OutwardWalk::Step& s, const EdgeWeight& v, const OutwardWalk::Step& t,
             const EdgeWeight& w) {
        const Pair x(s.along[0], t.along[0]), y(s.along[1], t.along[1]), z(s.along[2], t.along[2]);
        const Pair outward(s.outward, t.outward);
        const Pair from(walk_.reached()[s.reached].square, walk_.reached()[t.reached].square);
        const Pair per_square(v.per_square, w.per_square);
        const Pair weight(v.tensor, w.tensor);
        const Pair wx = weight * x, wy = weight * y, wz = weight * z;
        const std::array<Pair, 6> whole{wx * x, wx * y, wx * z, wy * y, wy * z, wz * z};
        const Pair square = x * x + y * y + z * z;
        for (std::size_t k = 0; k < scales; ++k) {
            // |start + share along| = radius, the root ahead; all of it where that lies beyond its end, and nothing
            // where it starts outside
            const Pair root = (outward * outward - square * (from - squares_[k])).max(0.0).sqrt();
            const Pair share = ((root - outward) * per_square).max(0.0).min(1.0);
            for (std::size_t i = 0; i < whole.size(); ++i)
                sums_[k][i] += share * whole[i];
        }
    }

    const std::vector<EdgeWeight>& weights_;
    PerScale squares_{};
    double largest_;
    OutwardWalk walk_;
    std::array<std::array<Pair, 6>, scales> sums_;
};

} // namespace

std::vector<PerScale> curvature_magnitudes(const TriangleMesh& mesh, const EdgeGraph& graph,
                                           const std::vector<double>& angles, const PerScale& radii,
                                           std::span<const char> wanted) {
    const std::size_t count = mesh.positions.size();
    const std::vector<EdgeWeight> weights = edge_weights(mesh, graph, angles);
    std::vector<PerScale> curvature(count, PerScale{});
    parallel_blocks(count, walk_block(count), [&](std::size_t begin, std::size_t end) {
        Balls balls(mesh, graph, weights, radii);
        for (std::size_t v = begin; v < end; ++v) {
            if (!wanted.empty() && !wanted[v])
                continue;
            const auto tensors = balls.tensors(static_cast<Index>(v));
            curvature[v] = magnitudes(tensors);
            for (std::size_t k = 0; k < radii.size(); ++k)
                curvature[v][k] /= std::numbers::pi * radii[k] * radii[k];
        }
    });
    return curvature;
}

} // namespace wm3d::metrics
