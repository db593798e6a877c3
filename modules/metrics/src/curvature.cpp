// SPDX-License-Identifier: GPL-3.0-or-later
#include "curvature.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <numeric>

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

/// The tensors of the balls around a vertex, two edges at a time.
class Balls {
public:
    Balls(const TriangleMesh& mesh, const EdgeGraph& graph, const std::vector<Bend>& bends,
          const PerScale& radii)
        : graph_(graph), bends_(bends), walk_(mesh, graph) {
        std::iota(ascending_.begin(), ascending_.end(), std::size_t{0});
        std::ranges::stable_sort(ascending_, {}, [&](std::size_t k) { return radii[k]; });
        for (std::size_t i = 0; i < scales; ++i) {
            radii_[i] = radii[ascending_[i]];
            squares_[i] = radii_[i] * radii_[i];
        }
    }

    std::array<Symmetric, scales> tensors(Index centre) {
        walk_.from(centre, radii_.back());
        for (std::size_t k = 0; k < scales; ++k) {
            whole_[k].fill(Pair::Zero());
            crossing_[k].fill(Pair::Zero());
        }
        const std::span<const OutwardWalk::Step> steps = walk_.steps();
        const std::size_t from_centre = graph_.ways_from(centre).size();
        for_pairs(steps.first(from_centre), [&](const Edges& pair) { add_from_centre(pair); });
        for_pairs(steps.subspan(from_centre), [&](const Edges& pair) { add_farther(pair); });
        std::array<Symmetric, scales> tensors;
        Symmetric within{};
        for (std::size_t k = 0; k < scales; ++k)
            for (std::size_t i = 0; i < within.size(); ++i) {
                within[i] += whole_[k][i].sum();
                tensors[ascending_[k]][i] = within[i] + crossing_[k][i].sum();
            }
        return tensors;
    }

private:
    using Pair = Eigen::Array<double, 2, 1>;
    using Tensor = std::array<Pair, std::tuple_size_v<Symmetric>>;

    /// Two edges of a walk.
    struct Edges {
        const OutwardWalk::Step& s;
        const OutwardWalk::Step& t;
        Pair x, y, z, per_length;
        Tensor whole; ///< angle(e) length(e) e e^T of a unit e

        Edges(const OutwardWalk::Step& first, const Bend& of_first, const OutwardWalk::Step& second,
              const Bend& of_second)
            : s(first), t(second), x(s.along[0], t.along[0]), y(s.along[1], t.along[1]),
              z(s.along[2], t.along[2]), per_length(of_first.per_length, of_second.per_length) {
            const Pair weight(of_first.angle_per_length, of_second.angle_per_length);
            const Pair wx = weight * x, wy = weight * y, wz = weight * z;
            whole = {wx * x, wx * y, wx * z, wy * y, wy * z, wz * z};
        }
    };

    static void add(const Pair& share, const Tensor& tensor, Tensor& sum) {
        for (std::size_t i = 0; i < sum.size(); ++i)
            sum[i] += share * tensor[i];
    }

    template<typename Visitor>
    void for_pairs(std::span<const OutwardWalk::Step> steps, Visitor&& visit) const {
        const OutwardWalk::Step nothing;
        for (std::size_t i = 0; i < steps.size(); i += 2)
            if (i + 1 < steps.size())
                visit(Edges(steps[i], bends_[steps[i].edge], steps[i + 1], bends_[steps[i + 1].edge]));
            else
                visit(Edges(steps[i], bends_[steps[i].edge], nothing, {}));
    }

    void add_from_centre(const Edges& pair) {
        for (std::size_t k = 0; k < scales; ++k)
            add((radii_[k] * pair.per_length).min(1.0), pair.whole, crossing_[k]);
    }

    void add_farther(const Edges& pair) {
        const double farthest = std::max(pair.s.to_square, pair.t.to_square);
        std::size_t k = 0;
        for (; k < scales && farthest > squares_[k]; ++k)
            add(share_within(squares_[k], pair), pair.whole, crossing_[k]);
        if (k < scales)
            add(Pair::Ones(), pair.whole, whole_[k]);
    }

    /// |start + share along| = radius, the root ahead; all of it where that lies beyond its end, and nothing where it
    /// starts outside.
    Pair share_within(double square_radius, const Edges& pair) const {
        const Pair outward(pair.s.outward, pair.t.outward);
        const Pair from(walk_.reached()[pair.s.reached].square, walk_.reached()[pair.t.reached].square);
        const Pair square = pair.x * pair.x + pair.y * pair.y + pair.z * pair.z;
        const Pair root = (outward * outward - square * (from - square_radius)).max(0.0).sqrt();
        return ((root - outward) * (pair.per_length * pair.per_length)).max(0.0).min(1.0);
    }

    const EdgeGraph& graph_;
    const std::vector<Bend>& bends_;
    std::array<std::size_t, scales> ascending_; ///< numbers of the scales, by their radii
    PerScale radii_{}, squares_{};              ///< ascending
    OutwardWalk walk_;
    std::array<Tensor, scales> whole_; ///< of edges that this ball holds and no smaller one does
    std::array<Tensor, scales>
        crossing_; ///< of those that no smaller one holds, and this one in part at most
};

} // namespace

std::vector<PerScale> curvature_magnitudes(const TriangleMesh& mesh, const EdgeGraph& graph,
                                           const std::vector<Bend>& bends, const PerScale& radii,
                                           std::span<const char> wanted) {
    const std::size_t count = mesh.positions.size();
    std::vector<PerScale> curvature(count, PerScale{});
    parallel_blocks(count, walk_block(count), [&](std::size_t begin, std::size_t end) {
        Balls balls(mesh, graph, bends, radii);
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
