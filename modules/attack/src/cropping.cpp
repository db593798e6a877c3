// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/attack/cropping.hpp>

#include <algorithm>
#include <cmath>
#include <map>
#include <numbers>
#include <numeric>

#include <wm3d/attack/random.hpp>
#include <wm3d/core/error.hpp>

#include "capping.hpp"
#include "manifold.hpp"

namespace wm3d::attack {

namespace {

Vec3 random_direction(std::uint64_t seed) {
    const RandomStream random(seed, 0);
    const double height = random.between(0, -1, 1);
    const double longitude = random.between(1, 0, 2 * std::numbers::pi);
    const double radius = std::sqrt(1 - height * height);
    return {radius * std::cos(longitude), radius * std::sin(longitude), height};
}

/// A value with `removed` of the heights above it, or nearly so where equal heights forbid it.
double cut_height(std::vector<double> heights, std::size_t removed) {
    std::sort(heights.begin(), heights.end());
    const std::size_t kept = heights.size() - removed;
    // Gaps between different heights, nearest to the wanted one first.
    for (std::size_t off = 0; off < heights.size(); ++off)
        for (const std::size_t gap : {kept - off, kept + off})
            if (gap > 0 && gap < heights.size() && heights[gap - 1] < heights[gap])
                return std::midpoint(heights[gap - 1], heights[gap]);
    throw GeometryError(
        "all vertices lie in one plane across the direction of the cut, so the cut would leave all "
        "of them or none; choose another direction");
}

/// Keeps height(v) <= 0 of a mesh: whole triangles, and parts of those that cross.
class Clipper {
public:
    Clipper(const TriangleMesh& mesh, std::vector<double> heights)
        : mesh_(mesh), height_(std::move(heights)) {
        result_.positions = mesh.positions;
    }

    /// The clipped mesh; with the segments along the cut, each as the clipped triangle walks it.
    TriangleMesh clip(std::vector<std::array<Index, 2>>& cut) {
        for (const Triangle& t : mesh_.triangles)
            clip_triangle(t, cut);
        return std::move(result_);
    }

private:
    bool inside(Index v) const { return height_[v] <= 0; }

    /// The vertex where edge a-b meets the plane, made on first use.
    Index crossing(Index a, Index b) {
        const auto [low, high] = std::minmax(a, b); // one order, so that both triangles agree to the last bit
        const auto [at, is_new] =
            crossings_.try_emplace({low, high}, static_cast<Index>(result_.positions.size()));
        if (is_new) {
            const double s = height_[low] / (height_[low] - height_[high]);
            result_.positions.push_back((1 - s) * mesh_.positions[low] + s * mesh_.positions[high]);
        }
        return at->second;
    }

    /// Sutherland and Hodgman on one triangle: at most four corners.
    void clip_triangle(const Triangle& t, std::vector<std::array<Index, 2>>& cut) {
        std::array<Index, 4> polygon{};
        std::size_t corners = 0;
        std::array<Index, 2> segment{no_index, no_index}; // where the boundary leaves, where it comes back
        for (std::size_t k = 0; k < 3; ++k) {
            const Index v = t[k], w = t[(k + 1) % 3];
            if (inside(v))
                polygon[corners++] = v;
            if (inside(v) != inside(w)) {
                const Index x = crossing(v, w);
                polygon[corners++] = x;
                segment[inside(v) ? 0 : 1] = x;
            }
        }
        for (std::size_t k = 2; k < corners; ++k)
            result_.triangles.push_back({polygon[0], polygon[k - 1], polygon[k]});
        if (segment[0] != no_index)
            cut.push_back(segment);
    }

    const TriangleMesh& mesh_;
    std::vector<double> height_;
    TriangleMesh result_;
    std::map<std::pair<Index, Index>, Index> crossings_;
};

} // namespace

TriangleMesh crop(const TriangleMesh& mesh, const CropOptions& options, std::uint64_t seed) {
    if (!(options.percent > 0 && options.percent < 100))
        throw ParameterError(
            "the percentage of vertices to cut off must lie between 0 and 100, both excluded");
    const Vec3 direction = options.normal ? *options.normal : random_direction(seed);
    if (!(direction.norm() > 0) || !direction.allFinite())
        throw ParameterError("the direction of the cut is zero; give one component other than 0");
    const Vec3 normal = direction.normalized();

    const TriangleMesh used = without_unused_vertices(mesh);
    std::vector<double> heights;
    heights.reserve(used.positions.size());
    for (const Vec3& p : used.positions)
        heights.push_back(normal.dot(p));
    const auto removed =
        static_cast<std::size_t>(std::llround(options.percent / 100 * static_cast<double>(heights.size())));
    const double level = cut_height(heights, removed);
    for (double& h : heights)
        h -= level;

    std::vector<std::array<Index, 2>> cut;
    TriangleMesh cropped = Clipper(used, std::move(heights)).clip(cut);
    if (options.cap)
        cap(cropped, cut, normal);
    return without_unused_vertices(cropped);
}

} // namespace wm3d::attack
