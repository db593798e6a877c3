// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/metrics/msdm2.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <mutex>
#include <optional>
#include <span>

#include <wm3d/core/error.hpp>
#include <wm3d/core/parallel.hpp>
#include <wm3d/mesh/measure.hpp>

#include "curvature.hpp"
#include "edge_graph.hpp"
#include "msdm2_parts.hpp"
#include "msdm2_window.hpp"
#include "triangle_grid.hpp"

namespace wm3d::metrics {

namespace {

constexpr std::size_t vertex_block = 1024;

/// Windows of one parallel task, if not more: each task has marks for all vertices.
constexpr std::size_t window_block = 256;

/// Neighbouring windows that a task opens one after the other. Then it leaves as many to each of the others: where
/// vertices lie close together, windows take a hundred times as long.
constexpr std::size_t window_run = 32;

/// Of windows at one in so many vertices, marking what they reach costs less than it saves.
constexpr std::size_t far_apart = 64;

/// Numbers of the vertices of triangles, ascending.
std::vector<Index> used_vertices(const TriangleMesh& mesh, const EdgeGraph& graph) {
    std::vector<Index> used;
    for (Index v = 0; v < mesh.positions.size(); ++v)
        if (!graph.triangles_at(v).empty())
            used.push_back(v);
    if (used.empty())
        throw GeometryError("the mesh has no triangle, so there is nothing to see; check that the file holds "
                            "the model that you mean");
    return used;
}

} // namespace

struct Msdm2::Prepared {
    const SurfaceTree& tree;
    Msdm2Options options;
    EdgeGraph graph;         ///< of the reference
    std::vector<Bend> bends; ///< of its edges

    Prepared(const SurfaceTree& surface, const Msdm2Options& chosen)
        : tree(surface), options(chosen), graph(surface.mesh()), bends(bends_of(surface.mesh(), graph)),
          own_side(longest_side(surface.mesh())) {}

    /// Makes what `match` looks into.
    void get_ready_for_moves() const;

    /// The reference's point closest to where its vertex went.
    /// \pre  get_ready_for_moves()
    ClosestPoint match(Index vertex, const Vec3& moved) const;

    /// The reference's curvatures for S = `side`.
    std::vector<PerScale> curvatures(double side) const {
        return curvature_magnitudes(tree.mesh(), graph, bends, curvature_radii(side));
    }

    /// For the reference's own S, `own_side`.
    const std::vector<PerScale>& own_curvatures() const;

    /// Curvatures and matches of the vertices, or of those wanted; S is `side`.
    std::vector<WindowSample> samples(const TriangleMesh& distorted, const EdgeGraph& around, double side,
                                      const std::vector<PerScale>& of_reference,
                                      std::span<const char> wanted) const;

    /// Local distances at vertices; S is `side`.
    std::vector<double> local(const TriangleMesh& distorted, const EdgeGraph& around, double side,
                              const std::vector<PerScale>& of_reference, const std::vector<Index>& vertices,
                              std::span<const char> wanted = {}) const;

    /// Local distances at vertices, as published: S is that of the distorted mesh.
    std::vector<double> published(const TriangleMesh& distorted, const EdgeGraph& around,
                                  const std::vector<Index>& vertices) const {
        const double side = longest_side(distorted);
        return local(distorted, around, side, curvatures(side), vertices);
    }

    /// Whether each vertex, #V, is in reach of windows at some; S is that of the reference.
    std::vector<char> reached(const TriangleMesh& distorted, const EdgeGraph& around,
                              const std::vector<Index>& vertices) const;

    /// At vertices; S is that of the reference.
    Msdm2Sample sample(const TriangleMesh& distorted, const EdgeGraph& around,
                       std::vector<Index> vertices) const;

    /// Calls measure with the edges of a mesh, which may be those of the reference.
    template<typename Measure>
    auto with_graph(const TriangleMesh& distorted, Measure&& measure) const {
        if (distorted.triangles == tree.mesh().triangles &&
            distorted.positions.size() == tree.mesh().positions.size())
            return measure(graph);
        return measure(EdgeGraph(distorted));
    }

    double own_side;

private:
    PerScale curvature_radii(double side) const {
        return times(side * options.curvature_ratio, options.scales);
    }

    mutable std::once_flag ready_, curved_;
    mutable std::optional<TriangleGrid> grid_; ///< unless triangles are too uneven
    /// What is not more than the distance of each vertex of the reference from the triangles that it doesn't belong to, #V, as
    /// far as marks move.
    mutable std::vector<double> clearances_;
    mutable std::vector<PerScale> own_curvatures_; ///< made at first need
};

const std::vector<PerScale>& Msdm2::Prepared::own_curvatures() const {
    std::call_once(curved_, [&] { own_curvatures_ = curvatures(own_side); });
    return own_curvatures_;
}

void Msdm2::Prepared::get_ready_for_moves() const {
    constexpr double of_marks = 2.5e-3; // times the longest side: twice what all but few vertices move
    std::call_once(ready_, [&] {
        grid_ = TriangleGrid::over(tree.mesh(), tree.with_area());
        clearances_ = grid_ ? grid_->clearances(of_marks * own_side) : tree.clearances(of_marks * own_side);
    });
}

ClosestPoint Msdm2::Prepared::match(Index vertex, const Vec3& moved) const {
    const std::span<const Index> own = graph.triangles_at(vertex);
    if (own.empty())
        return tree.closest(moved);
    // All other triangles are farther than where the vertex was.
    if ((moved - tree.mesh().positions[vertex]).norm() < 0.499 * clearances_[vertex] &&
        tree.has_area(own.front()))
        return tree.closest_of(own, moved);
    if (grid_)
        if (const std::optional<Index> nearest = grid_->nearest(moved, vertex, own))
            return tree.on(*nearest, moved);
    return tree.closest(moved, vertex, own.front());
}

std::vector<WindowSample> Msdm2::Prepared::samples(const TriangleMesh& distorted, const EdgeGraph& around,
                                                   double side, const std::vector<PerScale>& of_reference,
                                                   std::span<const char> wanted) const {
    const std::vector<PerScale> of_distorted =
        curvature_magnitudes(distorted, around, bends_of(distorted, around), curvature_radii(side), wanted);
    const bool same_triangles = &around == &graph;
    if (same_triangles)
        get_ready_for_moves();
    std::vector<WindowSample> samples(distorted.positions.size());
    parallel_blocks(samples.size(), vertex_block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t v = begin; v < end; ++v) {
            if ((!wanted.empty() && !wanted[v]) || around.triangles_at(v).empty())
                continue;
            const Vec3& p = distorted.positions[v];
            const ClosestPoint match =
                same_triangles ? this->match(static_cast<Index>(v), p) : tree.closest(p);
            samples[v] = {match.position, times(side, of_distorted[v]),
                          times(side, blend(tree.mesh(), match.at.triangle, of_reference, p))};
        }
    });
    return samples;
}

std::vector<double> Msdm2::Prepared::local(const TriangleMesh& distorted, const EdgeGraph& around,
                                           double side, const std::vector<PerScale>& of_reference,
                                           const std::vector<Index>& vertices,
                                           std::span<const char> wanted) const {
    const PerScale radii = times(side, options.scales);
    const std::vector<WindowSample> of_vertices = samples(distorted, around, side, of_reference, wanted);
    std::vector<double> local(vertices.size());
    const std::size_t tasks = std::clamp<std::size_t>(local.size() / window_block, 1, 64);
    parallel_blocks(tasks, 1, [&](std::size_t task, std::size_t) {
        Msdm2Windows windows(distorted, around, of_vertices, radii, options);
        for (std::size_t begin = task * window_run; begin < local.size(); begin += tasks * window_run)
            for (std::size_t i = begin; i < std::min(begin + window_run, local.size()); ++i)
                local[i] = windows.local_distance(vertices[i]);
    });
    return local;
}

std::vector<char> Msdm2::Prepared::reached(const TriangleMesh& distorted, const EdgeGraph& around,
                                           const std::vector<Index>& vertices) const {
    std::vector<char> reached(distorted.positions.size(), 0);
    const auto mark = [&](Index v) { std::atomic_ref(reached[v]).store(1, std::memory_order_relaxed); };
    const double radius = own_side * *std::ranges::max_element(options.scales);
    parallel_blocks(vertices.size(), window_block, [&](std::size_t begin, std::size_t end) {
        OutwardWalk walk(distorted, around);
        for (std::size_t i = begin; i < end; ++i) {
            mark(vertices[i]);
            walk.from(vertices[i], radius);
            for (const OutwardWalk::Step& s : walk.steps())
                mark(s.to);
        }
    });
    return reached;
}

Msdm2Sample Msdm2::Prepared::sample(const TriangleMesh& distorted, const EdgeGraph& around,
                                    std::vector<Index> vertices) const {
    Msdm2Sample sample;
    sample.vertices = std::move(vertices);
    const bool sparse = sample.vertices.size() * far_apart <= distorted.positions.size();
    const std::vector<char> wanted =
        sparse ? reached(distorted, around, sample.vertices) : std::vector<char>();
    sample.local = local(distorted, around, own_side, own_curvatures(), sample.vertices, wanted);
    sample.mean = minkowski_mean(sample.local, options.exponent);
    return sample;
}

Msdm2::Msdm2(const SurfaceTree& reference, const Msdm2Options& options)
    : prepared_(std::make_unique<Prepared>(reference, options)) {}

Msdm2::~Msdm2() = default;
Msdm2::Msdm2(Msdm2&&) noexcept = default;
Msdm2& Msdm2::operator=(Msdm2&&) noexcept = default;

void Msdm2::get_ready_for_moves() const {
    prepared_->get_ready_for_moves();
}

double Msdm2::distance(const TriangleMesh& distorted) const {
    return prepared_->with_graph(distorted, [&](const EdgeGraph& around) {
        return minkowski_mean(prepared_->published(distorted, around, used_vertices(distorted, around)),
                              prepared_->options.exponent);
    });
}

std::vector<double> Msdm2::field(const TriangleMesh& distorted) const {
    return prepared_->with_graph(distorted, [&](const EdgeGraph& around) {
        const std::vector<Index> used = used_vertices(distorted, around);
        const std::vector<double> local = prepared_->published(distorted, around, used);
        std::vector<double> field(distorted.positions.size(), 0.0);
        for (std::size_t i = 0; i < used.size(); ++i)
            field[used[i]] = local[i];
        return field;
    });
}

Msdm2Sample Msdm2::sample(const TriangleMesh& distorted, std::size_t windows) const {
    return prepared_->with_graph(distorted, [&](const EdgeGraph& around) {
        return prepared_->sample(distorted, around, some_of(used_vertices(distorted, around), windows));
    });
}

Msdm2Sample Msdm2::at(const TriangleMesh& distorted, std::vector<Index> vertices) const {
    return prepared_->with_graph(distorted, [&](const EdgeGraph& around) {
        return prepared_->sample(distorted, around, std::move(vertices));
    });
}

double msdm2_mean(const TriangleMesh& distorted, const std::vector<double>& local, double exponent) {
    std::vector<char> used(local.size(), 0);
    for (const Triangle& t : distorted.triangles)
        for (Index v : t)
            used[v] = 1;
    std::vector<double> of_used;
    for (std::size_t v = 0; v < local.size(); ++v)
        if (used[v])
            of_used.push_back(local[v]);
    return minkowski_mean(of_used, exponent);
}

} // namespace wm3d::metrics
