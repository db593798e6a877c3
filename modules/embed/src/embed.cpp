// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/embed/embed.hpp>

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

#include <wm3d/core/error.hpp>
#include <wm3d/core/parallel.hpp>
#include <wm3d/mesh/measure.hpp>

namespace wm3d::embed {

namespace {

constexpr std::size_t block = 8192;

/// alpha v_1 + beta v_2 + gamma v_3 on base triangle T(v_1, v_2, v_3).
Vec3 on_base(const TriangleMesh& base, std::span<const Vec3> positions, const SurfacePoint& place) {
    const Triangle& t = base.triangles[place.triangle];
    return place.barycentric[0] * positions[t[0]] + place.barycentric[1] * positions[t[1]] +
           place.barycentric[2] * positions[t[2]];
}

bool any_corner_moved(const TriangleMesh& base, std::span<const Vec3> moved, const SurfacePoint& place) {
    return std::ranges::any_of(base.triangles[place.triangle],
                               [&](Index v) { return moved[v] != base.positions[v]; });
}

void require_same(std::size_t a, std::size_t b, const char* what) {
    if (a != b)
        throw ParameterError(fmt::format("{}: {} and {}", what, a, b));
}

} // namespace

std::vector<Vec3> mark_base(std::span<const Vec3> base, std::span<const double> delta, double gamma) {
    require_same(base.size(), delta.size(), "there have to be as many base vertices as bumps");
    std::vector<Vec3> marked(base.begin(), base.end());
    for (std::size_t i = 0; i < marked.size(); ++i) {
        const double r = marked[i].norm();
        if (r > 0)
            marked[i] *= marked_radius(r, gamma, delta[i]) / r; // eq. (3)
    }
    return marked;
}

DetailedMesh::DetailedMesh(const TriangleMesh& mesh, const TriangleMesh& base,
                           std::span<const SurfacePoint> place)
    : base_(base), position_(mesh.positions), detail_(mesh.positions.size(), Vec3::Zero()),
      place_(place.begin(), place.end()) {
    require_same(mesh.positions.size(), place.size(), "every vertex needs a place on the base domain");
    for (std::size_t i = 0; i < place_.size(); ++i)
        if (place_[i].triangle != no_index)
            detail_[i] = position_[i] - on_base(base_, base_.positions, place_[i]); // t = P - p
}

std::vector<Vec3> DetailedMesh::reconstruct(std::span<const Vec3> moved_base) const {
    require_same(moved_base.size(), base_.positions.size(), "every base vertex needs a position");
    std::vector<Vec3> moved = position_;
    parallel_blocks(moved.size(), block, [&](std::size_t begin, std::size_t end) {
        for (std::size_t i = begin; i < end; ++i)
            if (place_[i].triangle != no_index && any_corner_moved(base_, moved_base, place_[i]))
                moved[i] = detail_[i] + on_base(base_, moved_base, place_[i]); // P_w = t + p_w
    });
    return moved;
}

Distortion distortion(const TriangleMesh& mesh, std::span<const Vec3> moved) {
    return distortion(mesh, moved, vertex_normals(mesh));
}

Distortion distortion(const TriangleMesh& mesh, std::span<const Vec3> moved, std::span<const Vec3> normals) {
    require_same(mesh.positions.size(), moved.size(), "the moved mesh needs the same vertices");
    const std::vector<double> areas = vertex_areas(mesh);
    Distortion d;
    double area = 0, along_normal = 0, squares = 0;
    for (std::size_t i = 0; i < moved.size(); ++i) {
        const Vec3 move = moved[i] - mesh.positions[i];
        const double normal_part = move.dot(normals[i]);
        along_normal += areas[i] * normal_part * normal_part;
        area += areas[i];
        squares += move.squaredNorm();
        d.max = std::max(d.max, move.norm());
    }
    if (area > 0)
        d.normal_rms = std::sqrt(along_normal / area);
    if (!moved.empty())
        d.vertex_rms = std::sqrt(squares / static_cast<double>(moved.size()));
    return d;
}

} // namespace wm3d::embed
