// SPDX-License-Identifier: GPL-3.0-or-later
#include "symmetric_rows.hpp"

#include <algorithm>
#include <array>
#include <span>

#include <wm3d/core/filed.hpp>
#include <wm3d/core/parallel.hpp>
#include <wm3d/mesh/measure.hpp>

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
            const double twice_area = std::max(area_vector(mesh, f).norm(), 1e-300);
            const Triangle& t = mesh.triangles[f];
            for (std::size_t k = 0; k < 3; ++k) {
                const Vec3& apex = mesh.positions[t[k]];
                const Vec3 a = mesh.positions[t[(k + 1) % 3]] - apex,
                           b = mesh.positions[t[(k + 2) % 3]] - apex;
                weights[f][k] =
                    static_cast<Value>(std::clamp(0.5 * a.dot(b) / twice_area, least_weight, most_weight));
            }
        }
    });
    return weights;
}

/// The triangles at each vertex, ascending.
Filed<Index> triangles_at_vertices(const TriangleMesh& mesh) {
    return filed<Index>(mesh.positions.size(), mesh.triangles.size(), [&](auto&& file) {
        for (Index f = 0; f < mesh.triangles.size(); ++f)
            for (const Index v : mesh.triangles[f])
                file(v, [&] { return f; });
    });
}

struct Entry {
    Index column;
    double value;
};

/// One entry for each triangle at each edge of a vertex, by columns.
template<typename Value>
void edge_entries(const TriangleMesh& mesh, std::span<const std::array<Value, 3>> weights,
                  std::span<const Index> triangles, Index v, std::vector<Entry>& entries) {
    entries.clear();
    for (const Index f : triangles) {
        const Triangle& t = mesh.triangles[f];
        for (std::size_t k = 0; k < 3; ++k) {
            const Index i = t[(k + 1) % 3], j = t[(k + 2) % 3];
            if (i == v || j == v)
                entries.push_back({i == v ? j : i, -double{weights[f][k]}});
        }
    }
    std::ranges::sort(entries, {}, &Entry::column); // two of a column, but where edges have more triangles
}

std::size_t neighbours(const TriangleMesh& mesh, std::span<const Index> triangles, Index v,
                       std::vector<Index>& others) {
    others.clear();
    for (const Index f : triangles)
        std::ranges::copy_if(mesh.triangles[f], std::back_inserter(others), [&](Index u) { return u != v; });
    std::ranges::sort(others);
    return static_cast<std::size_t>(std::unique(others.begin(), others.end()) - others.begin());
}

} // namespace

template<typename Value>
SymmetricRowsOf<Value> cotangent_laplacian(const TriangleMesh& mesh) {
    const Filed<Index> around = triangles_at_vertices(mesh);
    const std::vector<std::array<Value, 3>> weights = half_cotangents<Value>(mesh);
    const std::size_t count = mesh.positions.size();
    SymmetricRowsOf<Value> rows;
    rows.diagonal.resize(count);
    rows.start.assign(count + 1, 0);
    parallel_blocks(count, row_block, [&](std::size_t begin, std::size_t end) {
        std::vector<Index> others;
        for (std::size_t v = begin; v < end; ++v)
            rows.start[v + 1] =
                static_cast<Index>(neighbours(mesh, around.under(v), static_cast<Index>(v), others));
    });
    for (std::size_t v = 0; v < count; ++v)
        rows.start[v + 1] += rows.start[v];
    rows.column.resize(rows.start.back());
    rows.value.resize(rows.start.back());
    parallel_blocks(count, row_block, [&](std::size_t begin, std::size_t end) {
        std::vector<Entry> entries;
        for (std::size_t v = begin; v < end; ++v) {
            edge_entries<Value>(mesh, weights, around.under(v), static_cast<Index>(v), entries);
            double diagonal = 0;
            Index place = rows.start[v];
            for (std::size_t i = 0; i < entries.size();) {
                double sum = 0;
                const Index column = entries[i].column;
                for (; i < entries.size() && entries[i].column == column; ++i) {
                    diagonal -= entries[i].value;
                    sum += entries[i].value;
                }
                rows.column[place] = column;
                rows.value[place++] = static_cast<Value>(sum);
            }
            rows.diagonal[v] = static_cast<Value>(diagonal);
        }
    });
    return rows;
}

template SymmetricRowsOf<float> cotangent_laplacian(const TriangleMesh&);
template SymmetricRowsOf<double> cotangent_laplacian(const TriangleMesh&);

} // namespace wm3d::detect
