// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/metrics/msdm2_patches.hpp>

#include <algorithm>
#include <atomic>
#include <cmath>
#include <functional>
#include <memory>
#include <mutex>
#include <numbers>
#include <span>
#include <utility>

#include <wm3d/core/error.hpp>
#include <wm3d/core/memory.hpp>
#include <wm3d/core/parallel.hpp>
#include <wm3d/mesh/measure.hpp>

#include "closest_on_triangle.hpp"
#include "curvature.hpp"
#include "edge_graph.hpp"
#include "msdm2_parts.hpp"
#include "msdm2_window.hpp"
#include "surface_patches.hpp"
#include "triangle_boxes.hpp"

namespace wm3d::metrics {

namespace {

/// Cells along the box's longest side, as a power of two: of patches that hold many windows, on meshes that aren't too
/// large for so few, and of patches that hold about one.
constexpr int widest_cells = 2, narrow_cells = 5;

/// Triangles of a patch that holds many windows, about and at most.
constexpr double many_triangles = 131072;

/// Windows from which on wide patches take less work than narrow ones.
constexpr std::size_t many_windows = 2000;

/// Where one of so many vertices stands for all, windows are many edges wide: the reference's curvature at the corners of
/// a triangle is that at the vertex which is matched with it.
constexpr std::size_t fine_stride = 2;

/// What a patch has around its windows, in their radii, besides curvatures' balls and edges across the rim: triangles
/// that moved vertices lie closest to.
constexpr double reach = 1.1;

/// S times the curvatures of a vertex, in single precision; not a number where they aren't known.
using Known = std::array<float, std::tuple_size_v<PerScale>>;

double longest_edge(const TriangleMesh& mesh) {
    double square = 0;
    for (const Triangle& t : mesh.triangles)
        for (std::size_t k = 0; k < t.size(); ++k)
            square = std::max(square, (mesh.positions[t[k]] - mesh.positions[t[(k + 1) % 3]]).squaredNorm());
    return std::sqrt(square);
}

/// The triangles of a vertex of the reference that have an area, as answers to what is closest to a point.
void improve(NearestTriangle& best, const TriangleMesh& mesh, std::span<const Index> triangles,
             const Vec3& moved) {
    for (const Index f : triangles) {
        const NumberedTriangle t = numbered(mesh, f);
        if ((t.b - t.a).cross(t.c - t.a).squaredNorm() > 0)
            best.improve(moved, t);
    }
}

/// The reference's point that is closest to where a vertex went, as it is found from the vertex's own triangles, and
/// from those around the nearest corner as long as that comes closer. No triangle where none has an area.
SurfacePoint match(const TriangleMesh& mesh, const EdgeGraph& graph, Index vertex, const Vec3& moved) {
    NearestTriangle best;
    improve(best, mesh, graph.triangles_at(vertex), moved);
    for (Index around = vertex; best.triangle != no_index;) {
        const Triangle& t = mesh.triangles[best.triangle];
        const SurfacePoint at{best.triangle, closest_on_triangle(moved, mesh.positions[t[0]],
                                                                 mesh.positions[t[1]], mesh.positions[t[2]])};
        Eigen::Index nearest = 0;
        at.barycentric.maxCoeff(&nearest);
        const Index corner = t[static_cast<std::size_t>(nearest)];
        const double before = best.square;
        if (corner != around)
            improve(best, mesh, graph.triangles_at(corner), moved);
        if (corner == around || !(best.square < before))
            return at;
        around = corner;
    }
    return {};
}

/// Cells as wide as the memory of a patch allows: neighbours overlap by the radius of a window.
int wide_cells(const TriangleMesh& mesh) {
    constexpr double surface = 2.5; // of cells that a model runs through, over those of one side of its cube
    const double patches = static_cast<double>(mesh.triangles.size()) / many_triangles;
    int bits = widest_cells;
    while (bits < narrow_cells && patches > surface * std::ldexp(1, 2 * bits))
        ++bits;
    return bits;
}

/// Vertices that windows look at besides their centres: those kept within them and, where all are, those across their
/// rims.
std::vector<char> looked_at(const TriangleMesh& moved, const EdgeGraph& graph,
                            const std::vector<Index>& centres, double radius, const Thinning& thinning) {
    std::vector<char> wanted(moved.positions.size(), 0);
    OutwardWalk walk(moved, graph);
    for (const Index centre : centres) {
        walk.from(centre, radius);
        for (const OutwardWalk::Step& s : walk.steps())
            wanted[s.to] |= static_cast<char>(thinning.keeps(s.to));
    }
    return wanted;
}

/// These and some more: where windows overlap, that is less work than to walk through each.
std::vector<char> looked_at_nearly(const TriangleMesh& moved, const EdgeGraph& graph,
                                   const std::vector<Index>& centres, double radius,
                                   const Thinning& thinning) {
    std::vector<Vec3> places(centres.size());
    std::ranges::transform(centres, places.begin(), [&](Index centre) { return moved.positions[centre]; });
    const Box box = bounding_box(places);
    const Eigen::Array3d least = box.min.array() - radius, most = box.max.array() + radius;
    std::vector<char> wanted(moved.positions.size());
    for (Index v = 0; v < wanted.size(); ++v) {
        const auto p = moved.positions[v].array();
        wanted[v] = static_cast<char>(thinning.keeps(v) && (p >= least).all() && (p <= most).all());
    }
    if (!thinning.kept.empty())
        return wanted;
    std::vector<char> with_rims = wanted;
    for (const EdgeGraph::Edge& e : graph.edges())
        if (wanted[e.a] || wanted[e.b])
            with_rims[e.a] = with_rims[e.b] = 1;
    return with_rims;
}

/// What a patch takes, for the next one to take again: the system would give each its memory anew, page by page, a tenth of
/// the time of a dense mesh.
struct Room {
    SurfacePatch patch;
    EdgeGraph graph;
    std::vector<Bend> bends;
    std::vector<WindowSample> samples;
};

/// As many as are used at the same time.
class Rooms {
public:
    std::unique_ptr<Room> take() {
        const std::lock_guard lock(mutex_);
        if (free_.empty())
            return std::make_unique<Room>();
        std::unique_ptr<Room> room = std::move(free_.back());
        free_.pop_back();
        return room;
    }

    void give_back(std::unique_ptr<Room> room) {
        const std::lock_guard lock(mutex_);
        free_.push_back(std::move(room));
    }

private:
    std::mutex mutex_;
    std::vector<std::unique_ptr<Room>> free_;
};

} // namespace

struct Msdm2Patches::Prepared {
    const TriangleMesh& reference;
    Msdm2Options options;
    SurfacePatches patches;
    double side;       ///< S
    double around = 0; ///< windows, what a patch has
    double in_window;  ///< vertices of the widest, about
    mutable std::once_flag looked;
    mutable std::vector<Known> known; ///< of the reference, #V; made at the first look

    Prepared(const TriangleMesh& mesh, const Msdm2Options& chosen);

    PerScale radii() const { return times(side, options.scales); }
    PerScale curvature_radii() const { return times(side * options.curvature_ratio, options.scales); }
    double largest_radius() const { return side * *std::ranges::max_element(options.scales); }

    std::vector<Index> used_vertices() const;
    Msdm2Sample sample(const std::vector<Vec3>& distorted, std::vector<Index> vertices,
                       std::size_t stride) const;
    std::vector<double> local(const std::vector<Vec3>& distorted, const VertexGroup& group,
                              std::size_t stride, Room& room) const;
    std::vector<PerScale> curvatures(const Box& box, std::span<const char> wanted, Room& room) const;
    void make_samples(const Box& box, const TriangleMesh& moved, std::span<const char> wanted,
                      std::size_t stride, Room& room) const;
    bool recall(Index vertex, PerScale& value) const;
    PerScale remember(Index vertex, const PerScale& value) const;
};

Msdm2Patches::Prepared::Prepared(const TriangleMesh& mesh, const Msdm2Options& chosen)
    : reference(mesh), options(chosen), patches(mesh), side(longest_side(mesh)) {
    if (mesh.triangles.empty())
        throw GeometryError("the mesh has no triangle, so there is nothing to see; check that the file holds "
                            "the model that you mean");
    around =
        (reach + options.curvature_ratio) * largest_radius() + std::min(longest_edge(mesh), largest_radius());
    const double window = std::numbers::pi * largest_radius() * largest_radius();
    in_window = static_cast<double>(mesh.positions.size()) * std::min(1.0, window / surface_area(mesh));
}

std::vector<Index> Msdm2Patches::Prepared::used_vertices() const {
    std::vector<char> used(reference.positions.size(), 0);
    for (const Triangle& t : reference.triangles)
        for (const Index v : t)
            used[v] = 1;
    std::vector<Index> vertices;
    for (Index v = 0; v < used.size(); ++v)
        if (used[v])
            vertices.push_back(v);
    return vertices;
}

/// S times the curvatures of the patch's reference at wanted vertices, #V of the patch. Those whose balls lie in the
/// patch are the same from any patch, so they are made once.
std::vector<PerScale> Msdm2Patches::Prepared::curvatures(const Box& box, std::span<const char> wanted,
                                                         Room& room) const {
    const SurfacePatch& patch = room.patch;
    const Vec3 ball = Vec3::Constant(options.curvature_ratio * largest_radius());
    const auto is_whole = [&](std::size_t v) {
        const Vec3& p = patch.mesh.positions[v];
        return ((p - ball).array() >= box.min.array()).all() && ((p + ball).array() <= box.max.array()).all();
    };
    std::vector<PerScale> values(patch.vertices.size(), PerScale{});
    std::vector<char> missing(values.size(), 0);
    for (std::size_t v = 0; v < values.size(); ++v)
        if (wanted[v])
            missing[v] = static_cast<char>(!is_whole(v) || !recall(patch.vertices[v], values[v]));
    if (std::ranges::find(missing, 1) == missing.end())
        return values;
    make_bends(patch.mesh, room.graph, room.bends);
    const std::vector<PerScale> made =
        curvature_magnitudes(patch.mesh, room.graph, room.bends, curvature_radii(), missing);
    for (std::size_t v = 0; v < values.size(); ++v)
        if (missing[v])
            values[v] =
                is_whole(v) ? remember(patch.vertices[v], times(side, made[v])) : times(side, made[v]);
    return values;
}

/// Gives the curvature of the reference's vertex, if it is known.
bool Msdm2Patches::Prepared::recall(Index vertex, PerScale& value) const {
    for (std::size_t k = 0; k < value.size(); ++k)
        value[k] = std::atomic_ref(known[vertex][k]).load(std::memory_order_relaxed);
    return std::ranges::none_of(value, [](double x) { return std::isnan(x); });
}

/// The value as it will be recalled.
PerScale Msdm2Patches::Prepared::remember(Index vertex, const PerScale& value) const {
    PerScale stored{};
    for (std::size_t k = 0; k < value.size(); ++k) {
        const auto single = static_cast<float>(value[k]);
        std::atomic_ref(known[vertex][k]).store(single, std::memory_order_relaxed);
        stored[k] = single;
    }
    return stored;
}

void Msdm2Patches::Prepared::make_samples(const Box& box, const TriangleMesh& moved,
                                          std::span<const char> wanted, std::size_t stride,
                                          Room& room) const {
    const bool fine = stride >= fine_stride;
    const TriangleMesh& mesh = room.patch.mesh;
    std::vector<WindowSample>& samples = room.samples;
    samples.assign(wanted.size(), {});
    std::vector<Index> matched(wanted.size(), no_index); // triangles of the reference
    std::vector<char> corners(wanted.size(), 0);
    for (Index v = 0; v < wanted.size(); ++v) {
        if (!wanted[v])
            continue;
        const SurfacePoint found = match(mesh, room.graph, v, moved.positions[v]);
        matched[v] = found.triangle;
        if (found.triangle == no_index)
            continue;
        samples[v].match = evaluate(mesh, found);
        if (fine)
            corners[v] = 1;
        else
            for (const Index corner : mesh.triangles[found.triangle])
                corners[corner] = 1;
    }
    const std::vector<PerScale> of_reference = curvatures(box, corners, room);
    make_bends(moved, room.graph, room.bends);
    const std::vector<PerScale> of_moved =
        curvature_magnitudes(moved, room.graph, room.bends, curvature_radii(), wanted);
    for (std::size_t v = 0; v < wanted.size(); ++v)
        if (matched[v] != no_index) {
            samples[v].c = times(side, of_moved[v]);
            samples[v].c_hat =
                fine ? of_reference[v] : blend(mesh, matched[v], of_reference, moved.positions[v]);
        }
}

/// Local distances at the vertices of a group, which share a patch.
std::vector<double> Msdm2Patches::Prepared::local(const std::vector<Vec3>& distorted,
                                                  const VertexGroup& group, std::size_t stride,
                                                  Room& room) const {
    const Vec3 margin = Vec3::Constant(around);
    const Box box{group.box.min - margin, group.box.max + margin};
    patches.take(box, room.patch);
    const SurfacePatch& patch = room.patch;
    TriangleMesh moved{{}, patch.mesh.triangles};
    moved.positions.reserve(patch.vertices.size());
    std::vector<char> kept(stride > 1 ? patch.vertices.size() : 0);
    for (std::size_t v = 0; v < patch.vertices.size(); ++v) {
        moved.positions.push_back(distorted[patch.vertices[v]]);
        if (stride > 1)
            kept[v] = patch.vertices[v] % stride == 0;
    }
    room.graph.assign(patch.mesh);
    const Thinning thinning{stride, kept};
    std::vector<Index> centres(group.vertices.size());
    std::ranges::transform(group.vertices, centres.begin(), [&](Index v) { return patch.local(v); });
    const bool overlap =
        static_cast<double>(centres.size()) * in_window > 2 * static_cast<double>(patch.vertices.size());
    std::vector<char> wanted =
        (overlap ? looked_at_nearly : looked_at)(moved, room.graph, centres, largest_radius(), thinning);
    for (const Index centre : centres)
        wanted[centre] = 1;
    make_samples(box, moved, wanted, stride, room);
    const PerScale radii = this->radii();
    Msdm2Windows windows(moved, room.graph, room.samples, radii, options, thinning);
    std::vector<double> local(centres.size());
    for (std::size_t i = 0; i < local.size(); ++i)
        local[i] = windows.local_distance(centres[i]);
    return local;
}

Msdm2Sample Msdm2Patches::Prepared::sample(const std::vector<Vec3>& distorted, std::vector<Index> vertices,
                                           std::size_t stride) const {
    std::call_once(looked, [&] { known.assign(reference.positions.size(), Known{NAN, NAN, NAN}); });
    Msdm2Sample sample;
    sample.vertices = std::move(vertices);
    sample.local.resize(sample.vertices.size());
    std::vector<VertexGroup> groups =
        groups_of(reference, sample.vertices,
                  sample.vertices.size() < many_windows ? narrow_cells : wide_cells(reference));
    // The longest first, so that all threads end at about the same time.
    std::ranges::stable_sort(groups, std::ranges::greater{},
                             [](const VertexGroup& group) { return group.vertices.size(); });
    Rooms rooms;
    parallel_tasks(groups.size(), [&](std::size_t g) {
        std::unique_ptr<Room> room = rooms.take();
        const std::vector<double> local = this->local(distorted, groups[g], stride, *room);
        rooms.give_back(std::move(room));
        for (std::size_t i = 0; i < local.size(); ++i) {
            const auto at = std::ranges::lower_bound(sample.vertices, groups[g].vertices[i]);
            sample.local[static_cast<std::size_t>(at - sample.vertices.begin())] = local[i];
        }
    });
    if (sample.vertices.size() >= many_windows)
        return_freed_memory(); // of the patches
    sample.mean = minkowski_mean(sample.local, options.exponent);
    return sample;
}

Msdm2Patches::Msdm2Patches(const TriangleMesh& reference, const Msdm2Options& options)
    : prepared_(std::make_unique<Prepared>(reference, options)) {}

Msdm2Patches::~Msdm2Patches() = default;
Msdm2Patches::Msdm2Patches(Msdm2Patches&&) noexcept = default;
Msdm2Patches& Msdm2Patches::operator=(Msdm2Patches&&) noexcept = default;

Msdm2Sample Msdm2Patches::sample(const std::vector<Vec3>& distorted, std::size_t windows,
                                 std::size_t window_vertices) const {
    return prepared_->sample(distorted, some_of(prepared_->used_vertices(), windows),
                             stride(window_vertices));
}

Msdm2Sample Msdm2Patches::at(const std::vector<Vec3>& distorted, std::vector<Index> vertices,
                             std::size_t window_vertices) const {
    return prepared_->sample(distorted, std::move(vertices), stride(window_vertices));
}

std::size_t Msdm2Patches::stride(std::size_t window_vertices) const {
    return std::max<std::size_t>(1, static_cast<std::size_t>(prepared_->in_window) / window_vertices);
}

} // namespace wm3d::metrics
