// SPDX-License-Identifier: GPL-3.0-or-later
#include "multilevel_diffusion.hpp"

#include <algorithm>
#include <numeric>

#include <wm3d/core/parallel.hpp>

namespace wm3d::detect {

namespace {

constexpr std::size_t level_block = 8192;
constexpr std::size_t fewest_rows = 500; ///< a level of fewer has no coarser one
constexpr float damping = 0.75F;         ///< of Jacobi's steps
constexpr int last_steps = 8;            ///< of them on the last level
/// What a jump between aggregates costs, over what a smooth change of the same size would.
constexpr double stiffness = 0.8;

/// Row of the next level for each row: one for each that has no neighbour in an earlier one yet, with its neighbours;
/// what is left over joins the neighbour that it hangs on to most.
std::vector<Index> aggregate(const SymmetricRowsOf<float>& rows, Index& count) {
    const auto size = static_cast<Index>(rows.diagonal.size());
    std::vector<Index> parent(size, no_index);
    count = 0;
    const auto columns = [&](Index i) {
        return std::span(rows.column).subspan(rows.start[i], rows.start[i + 1] - rows.start[i]);
    };
    for (Index i = 0; i < size; ++i) {
        const auto is_free = [&](Index j) { return parent[j] == no_index; };
        if (!is_free(i) || !std::ranges::all_of(columns(i), is_free))
            continue;
        parent[i] = count;
        for (const Index j : columns(i))
            parent[j] = count;
        ++count;
    }
    const std::vector<Index> first = parent;
    for (Index i = 0; i < size; ++i) {
        if (first[i] != no_index)
            continue;
        float most = 0;
        for (Index e = rows.start[i]; e < rows.start[i + 1]; ++e)
            if (first[rows.column[e]] != no_index && -rows.value[e] > most) {
                most = -rows.value[e];
                parent[i] = first[rows.column[e]];
            }
        if (parent[i] == no_index)
            parent[i] = count++;
    }
    return parent;
}

/// Numbers from 0 to #parent by their parents: `start` has #parents + 1.
std::vector<Index> children_of(const std::vector<Index>& parent, Index count, std::vector<Index>& start) {
    start.assign(count + 1, 0);
    for (const Index p : parent)
        ++start[p + 1];
    std::partial_sum(start.begin(), start.end(), start.begin());
    std::vector<Index> children(parent.size()), next(start.begin(), start.end() - 1);
    for (Index i = 0; i < parent.size(); ++i)
        children[next[parent[i]]++] = i;
    return children;
}

/// Rows of the aggregates: sums over pairs of their members.
SymmetricRowsOf<float> coarser(const SymmetricRowsOf<float>& rows, const std::vector<Index>& parent,
                               Index count) {
    std::vector<Index> first;
    const std::vector<Index> children = children_of(parent, count, first);
    struct Entry {
        Index column;
        float value;
    };
    std::vector<std::vector<Entry>> blocks((count + level_block - 1) / level_block);
    SymmetricRowsOf<float> coarse;
    coarse.diagonal.resize(count);
    coarse.start.assign(count + 1, 0);
    parallel_blocks(count, level_block, [&](std::size_t begin, std::size_t end) {
        std::vector<Entry> all, &merged = blocks[begin / level_block];
        for (std::size_t p = begin; p < end; ++p) {
            all.clear();
            for (Index c = first[p]; c < first[p + 1]; ++c)
                for (Index e = rows.start[children[c]]; e < rows.start[children[c] + 1]; ++e)
                    if (const Index other = parent[rows.column[e]]; other != p)
                        all.push_back({other, rows.value[e]});
            std::ranges::stable_sort(all, {}, &Entry::column);
            const std::size_t before = merged.size();
            double diagonal = 0;
            for (std::size_t i = 0; i < all.size();) {
                double sum = 0;
                const Index column = all[i].column;
                for (; i < all.size() && all[i].column == column; ++i)
                    sum += all[i].value;
                merged.push_back({column, static_cast<float>(stiffness * sum)});
                diagonal -= stiffness * sum;
            }
            coarse.diagonal[p] = static_cast<float>(diagonal);
            coarse.start[p + 1] = static_cast<Index>(merged.size() - before);
        }
    });
    std::partial_sum(coarse.start.begin(), coarse.start.end(), coarse.start.begin());
    coarse.column.reserve(coarse.start.back());
    coarse.value.reserve(coarse.start.back());
    for (const std::vector<Entry>& block : blocks)
        for (const Entry& entry : block) {
            coarse.column.push_back(entry.column);
            coarse.value.push_back(entry.value);
        }
    return coarse;
}

/// Row i of (M + tL) x.
template<typename Value>
Value row_times(std::span<const float> mass, const SymmetricRowsOf<float>& laplacian, Value t, std::size_t i,
                const std::vector<Value>& x) {
    Value beside = 0;
    for (Index e = laplacian.start[i]; e < laplacian.start[i + 1]; ++e)
        beside += static_cast<Value>(laplacian.value[e]) * x[laplacian.column[e]];
    return (static_cast<Value>(mass[i]) + t * static_cast<Value>(laplacian.diagonal[i])) * x[i] + t * beside;
}

/// Sum of `term` over all numbers below `count`, in a fixed order.
template<typename Term>
double sum_over(std::size_t count, Term&& term) {
    return parallel_sum_of(count, level_block, term);
}

template<typename Do>
void for_each_row(std::size_t count, Do&& act) {
    parallel_blocks(count, level_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            act(i);
    });
}

} // namespace

MultilevelDiffusion::MultilevelDiffusion(const TriangleMesh& mesh, std::span<const double> mass) {
    unit_ = sum_over(mass.size(), [&](std::size_t i) { return mass[i]; }) / static_cast<double>(mass.size());
    Level finest{{}, cotangent_laplacian<float>(mesh), {}};
    for (const double m : mass)
        finest.mass.push_back(static_cast<float>(m / unit_));
    levels_.push_back(std::move(finest));
    while (levels_.back().mass.size() > fewest_rows) {
        Level& fine = levels_.back();
        Index count = 0;
        fine.parent = aggregate(fine.laplacian, count);
        if (2 * count > fine.mass.size()) { // loose pieces, of which nothing is to be had
            fine.parent.clear();
            break;
        }
        Level coarse{std::vector<float>(count, 0.0F), coarser(fine.laplacian, fine.parent, count), {}};
        for (std::size_t i = 0; i < fine.parent.size(); ++i)
            coarse.mass[fine.parent[i]] += fine.mass[i];
        levels_.push_back(std::move(coarse));
    }
}

/// An approximate solution of `right` at a level and below it, into `solution`.
void MultilevelDiffusion::cycle(float t, std::size_t level, std::vector<Scratch>& at) const {
    const std::vector<float>& mass = levels_[level].mass; // no structured bindings: lambdas capture these
    const auto& laplacian = levels_[level].laplacian;
    const std::vector<Index>& parent = levels_[level].parent;
    const std::vector<float>& right = at[level].right;
    std::vector<float>& x = at[level].solution;
    std::vector<float>& residual = at[level].residual;
    const std::size_t count = mass.size();
    const auto diagonal = [&](std::size_t i) { return mass[i] + t * laplacian.diagonal[i]; };
    const auto residual_at = [&](std::size_t i) {
        return right[i] - row_times<float>(mass, laplacian, t, i, x);
    };
    const auto step = [&] {
        for_each_row(count,
                     [&](std::size_t i) { residual[i] = x[i] + damping * residual_at(i) / diagonal(i); });
        x.swap(residual);
    };
    for_each_row(count, [&](std::size_t i) { x[i] = damping * right[i] / diagonal(i); });
    if (parent.empty()) {
        for (int k = 1; k < last_steps; ++k)
            step();
        return;
    }
    for_each_row(count, [&](std::size_t i) { residual[i] = residual_at(i); });
    Scratch& below = at[level + 1];
    std::ranges::fill(below.right, 0.0F);
    for (std::size_t i = 0; i < count; ++i)
        below.right[parent[i]] += residual[i];
    cycle(t, level + 1, at);
    for_each_row(count, [&](std::size_t i) { x[i] += below.solution[parent[i]]; });
    step();
}

int MultilevelDiffusion::diffuse(double t, std::vector<double>& x, double tolerance, int most) const {
    const std::vector<float>& mass = levels_.front().mass;
    const auto& laplacian = levels_.front().laplacian;
    const std::size_t count = x.size();
    t /= unit_;
    std::vector<Scratch> scratch;
    for (const Level& level : levels_) {
        const std::size_t rows = level.mass.size();
        scratch.push_back({std::vector<float>(rows), std::vector<float>(rows), std::vector<float>(rows)});
    }
    const std::vector<float>& z = scratch.front().solution;
    std::vector<double> r(count), p(count, 0.0);
    std::vector<float> q(count); // its rounding is nothing beside the tolerance
    const double right = sum_over(count, [&](std::size_t i) {
        const double y = static_cast<double>(mass[i]) * x[i];
        r[i] = y - row_times<double>(mass, laplacian, t, i, x);
        scratch[0].right[i] = static_cast<float>(r[i]);
        return y * y;
    });
    double left = sum_over(count, [&](std::size_t i) { return r[i] * r[i]; });
    double before = 0;
    int steps = 0;
    for (; steps < most && left > tolerance * tolerance * right; ++steps) {
        cycle(static_cast<float>(t), 0, scratch);
        const double rz = sum_over(count, [&](std::size_t i) { return r[i] * static_cast<double>(z[i]); });
        const double beta = steps == 0 ? 0 : rz / before;
        for_each_row(count, [&](std::size_t i) { p[i] = static_cast<double>(z[i]) + beta * p[i]; });
        const double pq = sum_over(count, [&](std::size_t i) {
            const double product = row_times<double>(mass, laplacian, t, i, p);
            q[i] = static_cast<float>(product);
            return p[i] * product;
        });
        const double alpha = rz / pq;
        before = rz;
        left = sum_over(count, [&](std::size_t i) {
            x[i] += alpha * p[i];
            r[i] -= alpha * static_cast<double>(q[i]);
            scratch[0].right[i] = static_cast<float>(r[i]);
            return r[i] * r[i];
        });
    }
    return steps;
}

} // namespace wm3d::detect
