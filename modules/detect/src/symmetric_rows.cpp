// SPDX-License-Identifier: GPL-3.0-or-later
#include "symmetric_rows.hpp"

#include <algorithm>
#include <array>
#include <span>

#include <wm3d/core/parallel.hpp>

#include "edge_order.hpp"

namespace wm3d::detect {

namespace {

/// Half cotangents outside this range come from slivers and would only spoil the condition of the system.
constexpr double least_weight = 1e-6, most_weight = 50;

constexpr std::size_t row_block = 4096;

/// Half the cotangents of the triangles' angles, #F by 3: each the weight of the edge across.
template<typename Value>
std::vector<std::array<Value, 3>> half_cotangents(const TriangleMesh& mesh) {
    std::vector<std::array<Value, 3>> weights(mesh.triangles.size());
    parallel_blocks(weights.size(), row_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t f = begin; f < end; ++f) {
            const auto& [i, j, k] = mesh.triangles[f];
            const Vec3 &a = mesh.positions[i], &b = mesh.positions[j], &c = mesh.positions[k];
            const Vec3 ab = b - a, bc = c - b, ca = a - c;
            const double scale = 0.5 / std::max(ab.cross(ca).norm(), 1e-300); // over twice the area
            const auto weight = [&](double product) {
                return static_cast<Value>(std::clamp(-product * scale, least_weight, most_weight));
            };
            weights[f] = {weight(ca.dot(ab)), weight(ab.dot(bc)), weight(bc.dot(ca))};
        }
    });
    return weights;
}

/// Calls visit(low, high, weight) for every edge, in ascending order.
template<typename Value, typename Visitor>
void for_each_weight(const Filed<Spoke<Value>>& upward, Visitor&& visit) {
    for_each_edge(upward, [&](Index low, Index high, std::span<const Spoke<Value>> spokes) {
        double weight = 0;
        for (const Spoke<Value>& s : spokes)
            weight += s.value;
        visit(low, high, weight);
    });
}

} // namespace

template<typename Value>
SymmetricRowsOf<Value> cotangent_laplacian(const TriangleMesh& mesh, Index multiple) {
    const Filed<Spoke<Value>> upward =
        upward_spokes<Value>(mesh, [weights = half_cotangents<Value>(mesh)](std::size_t f, std::size_t k) {
            return weights[f][k];
        });
    const std::size_t count = mesh.positions.size(), triangles = mesh.triangles.size();
    std::vector<Index> below(count, 0), next(count, 0); // entries left of the diagonal, and right of it
    parallel_shares(count, triangles, [&](std::size_t begin, std::size_t end) {
        for_each_weight(upward, [&](Index low, Index high, double) {
            if (low >= begin && low < end)
                ++next[low];
            if (high >= begin && high < end)
                ++below[high];
        });
    });
    SymmetricRowsOf<Value> rows;
    rows.start.assign(count + 1, 0);
    for (std::size_t v = 0; v < count; ++v) {
        rows.start[v + 1] = rows.start[v] + (below[v] + next[v] + multiple - 1) / multiple * multiple;
        next[v] = rows.start[v] + below[v];
        below[v] = rows.start[v];
    }
    rows.column.resize(rows.start.back());
    rows.value.resize(rows.start.back());
    rows.diagonal.resize(count);
    const auto set = [&](Index place, Index column, double weight) {
        rows.column[place] = column;
        rows.value[place] = static_cast<Value>(-weight);
    };
    parallel_shares(count, triangles, [&](std::size_t begin, std::size_t end) {
        for_each_weight(upward, [&](Index low, Index high, double weight) {
            if (low >= begin && low < end)
                set(next[low]++, high, weight);
            if (high >= begin && high < end)
                set(below[high]++, low, weight);
        });
        for (std::size_t v = begin; v < end; ++v) {
            double sum = 0;
            for (Index e = rows.start[v]; e < next[v]; ++e)
                sum -= rows.value[e];
            rows.diagonal[v] = static_cast<Value>(sum);
            for (Index e = next[v]; e < rows.start[v + 1]; ++e)
                set(e, static_cast<Index>(v), 0);
        }
    });
    return rows;
}

template SymmetricRowsOf<float> cotangent_laplacian(const TriangleMesh&, Index);
template SymmetricRowsOf<double> cotangent_laplacian(const TriangleMesh&, Index);

} // namespace wm3d::detect
