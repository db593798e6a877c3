// SPDX-License-Identifier: GPL-3.0-or-later
#include "diffusion_levels.hpp"

#include <algorithm>
#include <numeric>
#include <utility>

#include <wm3d/core/parallel.hpp>

namespace wm3d::detect {

namespace {

constexpr std::size_t fewest_rows = 500; ///< a level of fewer has no coarser one
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

Members members_of(const std::vector<Index>& parent, Index count) {
    Members members;
    members.start.assign(count + 1, 0);
    for (const Index p : parent)
        ++members.start[p + 1];
    std::partial_sum(members.start.begin(), members.start.end(), members.start.begin());
    members.row.resize(parent.size());
    std::vector<Index> next(members.start.begin(), members.start.end() - 1);
    for (Index i = 0; i < parent.size(); ++i)
        members.row[next[parent[i]]++] = i;
    return members;
}

/// Rows of the aggregates: sums over pairs of their members.
SymmetricRowsOf<float> coarser(const SymmetricRowsOf<float>& rows, const std::vector<Index>& parent,
                               const Members& members) {
    struct Entry {
        Index column;
        float value;
    };
    const std::size_t count = members.start.size() - 1;
    std::vector<std::vector<Entry>> blocks((count + level_block - 1) / level_block);
    SymmetricRowsOf<float> coarse;
    coarse.diagonal.resize(count);
    coarse.start.assign(count + 1, 0);
    parallel_blocks(count, level_block, [&](std::size_t begin, std::size_t end) {
        std::vector<Entry> all, &merged = blocks[begin / level_block];
        for (std::size_t p = begin; p < end; ++p) {
            all.clear();
            for (const Index member : members.of(p))
                for (Index e = rows.start[member]; e < rows.start[member + 1]; ++e)
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
    coarse.column.resize(coarse.start.back());
    coarse.value.resize(coarse.start.back());
    parallel_blocks(count, level_block, [&](std::size_t begin, std::size_t) {
        Index place = coarse.start[begin];
        for (const Entry& entry : blocks[begin / level_block]) {
            coarse.column[place] = entry.column;
            coarse.value[place++] = entry.value;
        }
    });
    return coarse;
}

std::vector<float> sums_of_members(const std::vector<float>& x, const Members& members) {
    std::vector<float> sums(members.start.size() - 1, 0.0F);
    parallel_blocks(sums.size(), level_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t p = begin; p < end; ++p)
            for (const Index member : members.of(p))
                sums[p] += x[member];
    });
    return sums;
}

} // namespace

std::vector<DiffusionLevel> diffusion_levels(const TriangleMesh& mesh, std::span<const double> mass,
                                             double unit) {
    std::vector<DiffusionLevel> levels;
    levels.push_back({std::vector<float>(mass.size()), cotangent_laplacian<float>(mesh), {}});
    std::ranges::transform(mass, levels.front().mass.begin(),
                           [&](double m) { return static_cast<float>(m / unit); });
    while (levels.back().mass.size() > fewest_rows) {
        DiffusionLevel& fine = levels.back();
        Index count = 0;
        const std::vector<Index> parent = aggregate(fine.laplacian, count);
        if (2 * count > fine.mass.size()) // loose pieces, of which nothing is to be had
            break;
        fine.members = members_of(parent, count);
        DiffusionLevel coarse{
            sums_of_members(fine.mass, fine.members), coarser(fine.laplacian, parent, fine.members), {}};
        levels.push_back(std::move(coarse));
    }
    return levels;
}

} // namespace wm3d::detect
