// SPDX-License-Identifier: GPL-3.0-or-later
#include "thinning.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>
#include <optional>
#include <span>

#include <wm3d/core/memory.hpp>
#include <wm3d/core/parallel.hpp>
#include <wm3d/simplify/simplify.hpp>

#include "decimator.hpp"
#include "sites.hpp"
#include "surface.hpp"

namespace wm3d::simplify {

namespace {

/// Times its share of the target, by number or by need if that is more, what a block keeps.
struct Share {
    double by_number, by_need;
};

/// Of small blocks, each of which fits a cache; and of the few large ones of what is left, which leave little to be done in
/// one thread.
constexpr Share of_small{2, 4}, of_large{1.2, 1.6};
constexpr std::size_t large_blocks = 4;

constexpr Triangle gone{no_index, no_index, no_index};

/// A block of vertices and all triangles that touch it.
struct Block {
    std::size_t begin = 0, end = 0; ///< vertices
    std::vector<Index> faces;       ///< ascending
    double need = 0;

    bool has(Index v) const { return v >= begin && v < end; }
};

std::vector<Block> blocks_of(const Canonical& mesh, std::size_t size) {
    std::vector<Block> blocks((mesh.positions.size() + size - 1) / size);
    for (std::size_t b = 0; b < blocks.size(); ++b)
        blocks[b] = {b * size, std::min((b + 1) * size, mesh.positions.size()), {}};
    parallel_shares(blocks.size(), mesh.triangles.size(), [&](std::size_t first, std::size_t last) {
        const std::size_t begin = first * size, end = last * size;
        for (Index f = 0; f < mesh.triangles.size(); ++f)
            for (const Index v : mesh.triangles[f]) {
                if (v < begin || v >= end)
                    continue;
                std::vector<Index>& faces = blocks[v / size].faces;
                if (faces.empty() || faces.back() != f)
                    faces.push_back(f);
            }
    });
    return blocks;
}

/// What the surface of a block needs, in the unit of others.
double need_of(const Block& block, const Canonical& mesh) {
    std::vector<Vec3> vector(block.end - block.begin, Vec3::Zero()); // sums of area vectors
    std::vector<double> area(vector.size(), 0.0);
    for (const Index f : block.faces) {
        const Triangle& t = mesh.triangles[f];
        const Vec3& a = mesh.positions[t[0]];
        const Vec3 twice = (mesh.positions[t[1]] - a).cross(mesh.positions[t[2]] - a);
        for (const Index v : t)
            if (block.has(v)) {
                vector[v - block.begin] += twice;
                area[v - block.begin] += twice.norm();
            }
    }
    double need = 0;
    for (std::size_t i = 0; i < area.size(); ++i)
        if (area[i] > 0) {
            const double turn = std::sqrt(std::max(0.0, 1 - vector[i].norm() / area[i]));
            need += std::cbrt(turn * turn * area[i] * area[i]);
        }
    return need;
}

/// A block as a mesh of its own: its vertices, and behind them those that its triangles have in other blocks.
struct Piece {
    std::vector<Vec3> positions;
    std::vector<Triangle> triangles; ///< of the block's faces
    std::vector<bool> locked;        ///< with a neighbour in another block, or there itself
};

Piece piece_of(const Block& block, const Canonical& mesh) {
    const std::size_t inside = block.end - block.begin;
    std::vector<Index> others;
    for (const Index f : block.faces)
        std::ranges::copy_if(mesh.triangles[f], std::back_inserter(others),
                             [&](Index v) { return !block.has(v); });
    std::ranges::sort(others);
    others.erase(std::unique(others.begin(), others.end()), others.end());
    Piece piece;
    piece.positions.assign(mesh.positions.begin() + static_cast<std::ptrdiff_t>(block.begin),
                           mesh.positions.begin() + static_cast<std::ptrdiff_t>(block.end));
    for (const Index v : others)
        piece.positions.push_back(mesh.positions[v]);
    piece.locked.assign(inside, false);
    piece.locked.resize(piece.positions.size(), true);
    for (const Index f : block.faces) {
        Triangle t = mesh.triangles[f];
        const bool across = !std::ranges::all_of(t, [&](Index v) { return block.has(v); });
        for (Index& v : t) {
            v = block.has(v) ? v - static_cast<Index>(block.begin)
                             : static_cast<Index>(inside) +
                                   static_cast<Index>(std::ranges::lower_bound(others, v) - others.begin());
            if (across)
                piece.locked[v] = true;
        }
        piece.triangles.push_back(t);
    }
    return piece;
}

/// What became of a block.
struct ThinnedBlock {
    std::vector<Standing> standing; ///< of its vertices that live, with their numbers before
    std::vector<Index> removed;     ///< vertices
    double largest_error = 0;
};

/// Those of a block's vertices, of all in ascending order.
std::span<const Standing> standing_in(const Block& block, std::span<const Standing> all) {
    const auto begin = std::ranges::lower_bound(all, block.begin, {}, &Standing::vertex);
    return {begin, std::ranges::lower_bound(begin, all.end(), block.end, {}, &Standing::vertex)};
}

/// Thins a block down to a share of those of its vertices that may go, or as far as that goes, and writes its own
/// triangles anew; those that reach into other blocks, and that other blocks read, stay as they are.
/// \param standing  what the block's vertices stand for already
ThinnedBlock thin_block(const Block& block, double share, std::span<const Standing> standing, Canonical& mesh,
                        const Options& options) {
    const std::size_t inside = block.end - block.begin;
    ThinnedBlock result;
    Piece piece = piece_of(block, mesh);
    std::optional<Rings> rings = rings_of_manifold(piece.triangles, piece.positions.size(), inside);
    const auto free = static_cast<double>(std::ranges::count(piece.locked, false));
    const auto to_remove = static_cast<std::size_t>(free * std::max(0.0, 1 - share));
    if (!rings || to_remove == 0) {
        result.standing.assign(standing.begin(), standing.end());
        return result;
    }
    std::vector<Index> source(piece.positions.size());
    std::iota(source.begin(), source.end(), Index{0});
    Surface surface{std::move(*rings), std::move(source), std::move(piece.locked)};
    Sites sites = build_sites(surface, std::move(piece.positions), options, standing, block.begin);
    Decimator decimator(surface.rings, sites, options, nullptr);
    decimator.remove(to_remove, {});
    result.largest_error = decimator.largest_error();

    const auto whole = [&](Index v) { return static_cast<Index>(block.begin) + v; };
    // Other blocks read, at the same time, what reaches into them.
    const auto is_own = [&](std::size_t face) {
        return std::ranges::all_of(piece.triangles[face], [&](Index v) { return v < inside; });
    };
    for (std::size_t i = 0; i < block.faces.size(); ++i)
        if (is_own(i))
            mesh.triangles[block.faces[i]] = gone;
    for (Index v = 0; v < inside; ++v) {
        if (!surface.rings.alive(v)) {
            result.removed.push_back(whole(v));
            continue;
        }
        result.standing.push_back({whole(v), sites.quadric[v], sites.site[v].constant});
        for (const Spoke& s : surface.rings.of(v))
            if (s.corner != no_index && is_own(s.corner / 3))
                mesh.triangles[block.faces[s.corner / 3]][s.corner % 3] = whole(v);
    }
    return result;
}

/// Leaves out what is gone. Returns the new number of each vertex.
std::vector<Index> compact(Canonical& mesh, const std::vector<char>& removed) {
    std::vector<Index> number(mesh.positions.size(), no_index);
    Index count = 0;
    for (std::size_t v = 0; v < number.size(); ++v)
        if (!removed[v]) {
            mesh.positions[count] = mesh.positions[v];
            mesh.input_vertex[count] = mesh.input_vertex[v];
            number[v] = count++;
        }
    mesh.positions.resize(count);
    mesh.positions.shrink_to_fit();
    mesh.input_vertex.resize(count);
    mesh.input_vertex.shrink_to_fit();
    std::erase(mesh.triangles, gone);
    mesh.triangles.shrink_to_fit();
    for (Triangle& t : mesh.triangles)
        for (Index& v : t)
            v = number[v];
    return number;
}

/// Thins all blocks of a size.
void thin_blocks(Canonical& input, const Options& options, std::size_t size, const Share& share,
                 Thinning& thinning) {
    std::vector<Block> blocks = blocks_of(input, size);
    parallel_tasks(blocks.size(), [&](std::size_t b) { blocks[b].need = need_of(blocks[b], input); });
    double need = 0;
    for (const Block& each : blocks)
        need += each.need;
    const auto target = static_cast<double>(options.target_vertices);
    const double number = target / static_cast<double>(input.positions.size());
    std::vector<ThinnedBlock> thinned(blocks.size());
    parallel_tasks(blocks.size(), [&](std::size_t b) {
        const Block& each = blocks[b];
        const double needed =
            need > 0 ? target * each.need / need / static_cast<double>(each.end - each.begin) : 0;
        thinned[b] = thin_block(each, std::max(share.by_number * number, share.by_need * needed),
                                standing_in(each, thinning.standing), input, options);
    });

    std::vector<Block>().swap(blocks);
    return_freed_memory(); // of the pieces
    std::vector<char> removed(input.positions.size(), 0);
    for (const ThinnedBlock& each : thinned) {
        for (const Index v : each.removed)
            removed[v] = 1;
        thinning.removed += each.removed.size();
        thinning.largest_error = std::max(thinning.largest_error, each.largest_error);
    }
    const std::vector<Index> now = compact(input, removed);
    thinning.standing.clear();
    for (ThinnedBlock& each : thinned)
        for (Standing& standing : each.standing) {
            standing.vertex = now[standing.vertex];
            thinning.standing.push_back(standing);
        }
}

} // namespace

Thinning thin(Canonical& input, const Options& options, std::size_t block) {
    Thinning thinning;
    thin_blocks(input, options, block, of_small, thinning);
    return thinning;
}

void thin_further(Canonical& input, const Options& options, Thinning& thinning) {
    const std::size_t block = (input.positions.size() + large_blocks - 1) / large_blocks;
    thin_blocks(input, options, block, of_large, thinning);
}

} // namespace wm3d::simplify
