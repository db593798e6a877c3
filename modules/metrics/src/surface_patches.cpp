// SPDX-License-Identifier: GPL-3.0-or-later
#include "surface_patches.hpp"

#include <algorithm>
#include <bit>
#include <cstdint>
#include <utility>

#include <wm3d/core/parallel.hpp>
#include <wm3d/mesh/curve_order.hpp>

namespace wm3d::metrics {

namespace {

constexpr std::size_t run = 64; ///< triangles that share a box, and boxes that share one

Box box_of(const TriangleMesh& mesh, std::size_t begin, std::size_t end) {
    const Vec3& somewhere = mesh.positions[mesh.triangles[begin][0]];
    Box box{somewhere, somewhere};
    for (std::size_t f = begin; f < end; ++f)
        for (const Index v : mesh.triangles[f]) {
            box.min = box.min.cwiseMin(mesh.positions[v]);
            box.max = box.max.cwiseMax(mesh.positions[v]);
        }
    return box;
}

/// The box of boxes [begin, end).
Box box_of(const std::vector<Box>& boxes, std::size_t begin, std::size_t end) {
    Box box = boxes[begin];
    for (std::size_t i = begin + 1; i < end; ++i) {
        box.min = box.min.cwiseMin(boxes[i].min);
        box.max = box.max.cwiseMax(boxes[i].max);
    }
    return box;
}

bool meet(const Box& a, const Box& b) {
    return (a.min.array() <= b.max.array()).all() && (b.min.array() <= a.max.array()).all();
}

bool holds(const Box& a, const Box& b) {
    return (a.min.array() <= b.min.array()).all() && (b.max.array() <= a.max.array()).all();
}

/// A set of numbers that knows how many smaller ones it has.
class NumberSet {
public:
    explicit NumberSet(std::size_t end) : words_(end / 64 + 1, 0), before_(words_.size()) {}

    void insert(Index i) { words_[i / 64] |= std::uint64_t{1} << i % 64; }

    /// To be called after the last number is in. Returns them, ascending.
    std::vector<Index> count() {
        Index total = 0;
        for (std::size_t k = 0; k < words_.size(); ++k) {
            if (words_[k] == 0)
                continue;
            before_[k] = total;
            total += static_cast<Index>(std::popcount(words_[k]));
        }
        std::vector<Index> numbers;
        numbers.reserve(total);
        for (std::size_t k = 0; k < words_.size(); ++k)
            for (std::uint64_t rest = words_[k]; rest != 0; rest &= rest - 1)
                numbers.push_back(static_cast<Index>(64 * k) + static_cast<Index>(std::countr_zero(rest)));
        return numbers;
    }

    Index rank(Index i) const {
        const std::uint64_t smaller = words_[i / 64] & ((std::uint64_t{1} << i % 64) - 1);
        return before_[i / 64] + static_cast<Index>(std::popcount(smaller));
    }

private:
    std::vector<std::uint64_t> words_; ///< a bit for each number
    std::vector<Index> before_;        ///< numbers in the words before, of words that have any
};

} // namespace

Index SurfacePatch::local(Index vertex) const {
    return static_cast<Index>(std::ranges::lower_bound(vertices, vertex) - vertices.begin());
}

SurfacePatches::SurfacePatches(const TriangleMesh& mesh)
    : mesh_(mesh), runs_((mesh.triangles.size() + run - 1) / run),
      runs_of_runs_((runs_.size() + run - 1) / run) {
    parallel_blocks(runs_.size(), 256, [&](std::size_t begin, std::size_t end) {
        for (std::size_t r = begin; r < end; ++r)
            runs_[r] = box_of(mesh, r * run, std::min((r + 1) * run, mesh.triangles.size()));
    });
    for (std::size_t r = 0; r < runs_of_runs_.size(); ++r)
        runs_of_runs_[r] = box_of(runs_, r * run, std::min((r + 1) * run, runs_.size()));
}

/// Calls visit(r) for the runs of triangles whose boxes meet this one, in the order of the mesh.
template<typename Visitor>
void SurfacePatches::for_each_run(const Box& box, Visitor&& visit) const {
    for (std::size_t s = 0; s < runs_of_runs_.size(); ++s)
        if (meet(runs_of_runs_[s], box))
            for (std::size_t r = s * run; r < std::min((s + 1) * run, runs_.size()); ++r)
                if (meet(runs_[r], box))
                    visit(r);
}

void SurfacePatches::take(const Box& box, SurfacePatch& patch) const {
    patch.mesh.triangles.clear();
    patch.mesh.positions.clear();
    NumberSet corners(mesh_.positions.size());
    for_each_run(box, [&](std::size_t r) {
        const bool all = holds(box, runs_[r]);
        for (std::size_t f = r * run; f < std::min((r + 1) * run, mesh_.triangles.size()); ++f)
            if (all || meet(box_of(mesh_, f, f + 1), box)) {
                patch.mesh.triangles.push_back(mesh_.triangles[f]);
                for (const Index v : mesh_.triangles[f])
                    corners.insert(v);
            }
    });
    patch.vertices = corners.count();
    patch.mesh.positions.reserve(patch.vertices.size());
    for (const Index v : patch.vertices)
        patch.mesh.positions.push_back(mesh_.positions[v]);
    for (Triangle& t : patch.mesh.triangles)
        for (Index& v : t)
            v = corners.rank(v);
}

std::vector<VertexGroup> groups_of(const TriangleMesh& mesh, const std::vector<Index>& vertices, int bits) {
    const Box box = surface_box(mesh);
    const Vec3 centre = 0.5 * box.min + 0.5 * box.max;
    const double side = (box.max - box.min).maxCoeff();
    std::vector<std::pair<std::uint64_t, Index>> keyed;
    keyed.reserve(vertices.size());
    for (const Index v : vertices)
        keyed.emplace_back(morton_code((mesh.positions[v] - centre) / side) >> 3 * (morton_bits - bits), v);
    std::ranges::sort(keyed);
    std::vector<VertexGroup> groups;
    for (std::size_t i = 0; i < keyed.size(); ++i) {
        const Vec3& p = mesh.positions[keyed[i].second];
        if (i == 0 || keyed[i].first != keyed[i - 1].first)
            groups.push_back({{}, {p, p}});
        VertexGroup& group = groups.back();
        group.vertices.push_back(keyed[i].second);
        group.box.min = group.box.min.cwiseMin(p);
        group.box.max = group.box.max.cwiseMax(p);
    }
    return groups;
}

} // namespace wm3d::metrics
