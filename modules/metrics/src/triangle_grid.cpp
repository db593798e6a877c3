// SPDX-License-Identifier: GPL-3.0-or-later
#include "triangle_grid.hpp"

#include <algorithm>
#include <cmath>
#include <numeric>

#include <wm3d/core/parallel.hpp>

namespace wm3d::metrics {

namespace {

constexpr std::size_t grid_block = 4096;
constexpr double cells_per_triangle = 4;     ///< at most
constexpr double most_along = 1000;          ///< cells
constexpr std::size_t most_per_triangle = 8; ///< cells that meet one, in the mean
constexpr std::size_t most_cells = 64;       ///< that one search looks into

/// More than rounding moves a coordinate of at most `farthest`, and parts of a square.
constexpr float slack = 1e-6F, farthest = 4;

} // namespace

std::size_t TriangleGrid::Cells::count() const {
    std::size_t count = 1;
    for (std::size_t k = 0; k < 3; ++k)
        count *= std::size_t{last[k]} - first[k] + 1;
    return count;
}

TriangleGrid::Corner TriangleGrid::corner(const Vec3& p) const {
    Corner result = Corner::Zero();
    result.head<3>() = (per_unit_ * (p - origin_)).cast<float>().array();
    return result;
}

TriangleGrid::Cells TriangleGrid::cells(const Corner& min, const Corner& max) const {
    Cells cells{};
    for (std::size_t k = 0; k < 3; ++k) {
        const auto axis = static_cast<Eigen::Index>(k);
        const auto last = static_cast<float>(size_[k] - 1);
        cells.first[k] = static_cast<std::uint16_t>(std::clamp(min[axis] * per_cell_, 0.0F, last));
        cells.last[k] = static_cast<std::uint16_t>(std::clamp(max[axis] * per_cell_, 0.0F, last));
    }
    return cells;
}

TriangleGrid::Cells TriangleGrid::cells_around(const Corner& p, float radius) const {
    const float reach = radius * (1 + slack) + slack;
    return cells(p - reach, p + reach);
}

/// Calls visit(triangle) for those in the cells, some of them several times.
template<typename Visit>
void TriangleGrid::for_each(const Cells& cells, Visit&& visit) const {
    for (std::size_t z = cells.first[2]; z <= cells.last[2]; ++z)
        for (std::size_t y = cells.first[1]; y <= cells.last[1]; ++y) {
            const std::size_t row = (z * size_[1] + y) * size_[0];
            const Index end = first_[row + cells.last[0] + 1];
            for (Index i = first_[row + cells.first[0]]; i < end; ++i)
                visit(triangles_[i]);
        }
}

namespace {

/// The box around some triangles, and the sum of their own.
struct Extents {
    Vec3 low = Vec3::Constant(HUGE_VAL), high = Vec3::Constant(-HUGE_VAL), sum = Vec3::Zero();

    void add(const TriangleMesh& mesh, const Triangle& t) {
        const Vec3 &a = mesh.positions[t[0]], &b = mesh.positions[t[1]], &c = mesh.positions[t[2]];
        const Vec3 min = a.cwiseMin(b).cwiseMin(c), max = a.cwiseMax(b).cwiseMax(c);
        *this += {min, max, max - min};
    }
    Extents& operator+=(const Extents& other) {
        low = low.cwiseMin(other.low);
        high = high.cwiseMax(other.high);
        sum += other.sum;
        return *this;
    }
};

} // namespace

TriangleGrid::TriangleGrid(const TriangleMesh& mesh, std::span<const Index> triangles)
    : mesh_(&mesh), balls_(mesh.triangles.size(), Ball{Corner::Constant(-1)}) {
    const auto all =
        parallel_sum(triangles.size(), grid_block, Extents{}, [&](std::size_t begin, std::size_t end) {
            Extents part;
            for (std::size_t i = begin; i < end; ++i)
                part.add(mesh, mesh.triangles[triangles[i]]);
            return part;
        });
    const auto count = static_cast<double>(triangles.size());
    origin_ = all.low;
    per_unit_ = 1 / (all.high - all.low).maxCoeff();
    const Vec3 size = per_unit_ * (all.high - all.low);
    double cell = std::max(per_unit_ * all.sum.maxCoeff() / count, 1.0 / most_along);
    while (((size / cell).array().floor() + 1).prod() > cells_per_triangle * count + 8)
        cell *= 1.05;
    per_cell_ = static_cast<float>(1 / cell);
    for (std::size_t k = 0; k < 3; ++k)
        size_[k] = static_cast<std::uint16_t>(size[static_cast<Eigen::Index>(k)] / cell) + 1;
}

/// Takes a triangle in, and tells the cells that its box meets.
TriangleGrid::Cells TriangleGrid::take(Index triangle) {
    const Triangle& t = mesh_->triangles[triangle];
    const Corner a = corner(mesh_->positions[t[0]]), b = corner(mesh_->positions[t[1]]),
                 c = corner(mesh_->positions[t[2]]);
    Corner& centre = balls_[triangle].centre;
    centre = (a + b + c) / 3;
    const auto square = [&](const Corner& p) { return (p - centre).square().sum(); };
    centre[3] = std::sqrt(std::max({square(a), square(b), square(c)})) * (1 + slack) + slack;
    return cells(a.min(b).min(c) - slack, a.max(b).max(c) + slack);
}

std::optional<TriangleGrid> TriangleGrid::over(const TriangleMesh& mesh, std::span<const Index> triangles) {
    TriangleGrid grid(mesh, triangles);
    std::vector<Cells> met(triangles.size());
    const auto count =
        parallel_sum(triangles.size(), grid_block, std::size_t{0}, [&](std::size_t begin, std::size_t end) {
            std::size_t part = 0;
            for (std::size_t i = begin; i < end; ++i) {
                met[i] = grid.take(triangles[i]);
                part += met[i].count();
            }
            return part;
        });
    if (count > most_per_triangle * triangles.size())
        return std::nullopt;
    grid.file(triangles, met, count);
    return grid;
}

/// Files the triangles under the cells that they meet, `count` in all.
void TriangleGrid::file(std::span<const Index> triangles, std::span<const Cells> met, std::size_t count) {
    const auto for_each_cell = [&](const Cells& cells, auto&& visit) {
        for (std::size_t z = cells.first[2]; z <= cells.last[2]; ++z)
            for (std::size_t y = cells.first[1]; y <= cells.last[1]; ++y)
                for (std::size_t x = cells.first[0]; x <= cells.last[0]; ++x)
                    visit((z * size_[1] + y) * size_[0] + x);
    };
    first_.assign(std::size_t{size_[0]} * size_[1] * size_[2] + 1, 0);
    for (const Cells& cells : met)
        for_each_cell(cells, [&](std::size_t cell) { ++first_[cell]; });
    std::partial_sum(first_.begin(), first_.end(), first_.begin()); // now where each ends
    triangles_.resize(count);
    for (std::size_t i = triangles.size(); i-- > 0;)
        for_each_cell(met[i], [&](std::size_t cell) { triangles_[--first_[cell]] = triangles[i]; });
}

/// In the grid's units.
float TriangleGrid::clearance(Index vertex, float most) const {
    const Corner at = corner(mesh_->positions[vertex]);
    float least = most;
    for_each(cells_around(at, most), [&](Index f) {
        if (balls_[f].meets(at, least) && !has_corner(mesh_->triangles[f], vertex))
            least = std::min(least, balls_[f].clearance(at));
    });
    return std::max(0.0F, least - slack);
}

std::vector<double> TriangleGrid::clearances(double most) const {
    std::vector<double> clearances(mesh_->positions.size());
    parallel_blocks(clearances.size(), grid_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v)
            clearances[v] =
                static_cast<double>(clearance(static_cast<Index>(v), static_cast<float>(most * per_unit_))) /
                per_unit_;
    });
    return clearances;
}

void TriangleGrid::improve(NearestTriangle& known, const Vec3& query, Index triangle) const {
    known.improve(query, numbered(*mesh_, triangle));
}

std::optional<Index> TriangleGrid::nearest(const Vec3& query, Index vertex,
                                           std::span<const Index> own) const {
    NearestTriangle known;
    for (const Index f : own)
        if (has(f))
            improve(known, query, f);
    if (known.triangle == no_index)
        return std::nullopt;
    const Corner at = corner(query);
    const Cells cells = cells_around(at, static_cast<float>(std::sqrt(known.square) * per_unit_));
    if (!(at.abs() < farthest).all() || cells.count() > most_cells)
        return std::nullopt;
    const auto bound = [&] {
        return static_cast<float>(std::sqrt(known.square) * per_unit_) * (1 + slack) + slack;
    };
    float within = bound();
    for_each(cells, [&](Index f) {
        if (!balls_[f].meets(at, within) || has_corner(mesh_->triangles[f], vertex))
            return;
        improve(known, query, f);
        within = bound();
    });
    return known.triangle;
}

} // namespace wm3d::metrics
