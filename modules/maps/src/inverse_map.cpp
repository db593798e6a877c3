// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/maps/inverse_map.hpp>

#include <algorithm>
#include <cmath>
#include <limits>
#include <numeric>
#include <utility>

#include "chart.hpp"

namespace wm3d::maps {

namespace {

constexpr double same_place = 1e-12; ///< in barycentric coordinates

Corners corners_of(const TriangleMesh& mesh, Index t) {
    const Triangle& v = mesh.triangles[t];
    return {mesh.positions[v[0]], mesh.positions[v[1]], mesh.positions[v[2]]};
}

/// Barycentric coordinates in the plane; false if the triangle has no area.
bool planar_coordinates(const Vec2& p, const std::array<Vec2, 3>& t, Vec3& coordinates) {
    const Vec2 e1 = t[1] - t[0], e2 = t[2] - t[0], d = p - t[0];
    const double area = cross(e1, e2);
    if (!(std::abs(area) > 1e-14 * std::sqrt(e1.squaredNorm() * e2.squaredNorm())))
        return false;
    const double u = cross(d, e2) / area, v = cross(e1, d) / area;
    coordinates = {1 - u - v, u, v};
    return true;
}

/// Coordinates in base triangle `laid` of the images in the plane. A base triangle without area shares no
/// point.
bool images_in(const LaidOut& laid, const std::array<Vec2, 3>& points, Corners& images) {
    for (std::size_t i = 0; i < 3; ++i)
        if (!planar_coordinates(points[i], laid.corners, images[i]))
            return false;
    return true;
}

/// Whether a side of the base triangle has all images beyond it.
bool apart(const Corners& images) {
    for (int k = 0; k < 3; ++k)
        if (images[0][k] < 0 && images[1][k] < 0 && images[2][k] < 0)
            return true;
    return false;
}

std::array<Vec2, 3> in_plane(const Corners& images) {
    return {images[0].tail<2>(), images[1].tail<2>(), images[2].tail<2>()};
}

} // namespace

InverseMap::InverseMap(const TriangleMesh& original, const BaseDomain& domain)
    : original_(original), base_(domain.mesh), at_base_vertex_(domain.original.size(), no_index),
      original_vertex_(domain.original) {
    note_base_vertices();
    std::vector<Placed> placed;
    Unfolder unfolder(base_);
    for (Index t = 0; t < original_.triangles.size(); ++t) {
        const Triangle& v = original_.triangles[t];
        if (v[0] == v[1] || v[1] == v[2] || v[2] == v[0])
            continue;
        const std::array<SurfacePoint, 3> points{domain.point[v[0]], domain.point[v[1]], domain.point[v[2]]};
        if (!unfolder.unfold(points)) {
            ++left_out_;
            continue;
        }
        Corners images;
        for (const LaidOut& laid : unfolder.triangles())
            if (images_in(laid, unfolder.points(), images) && !apart(images))
                placed.push_back({laid.triangle, {t, images}});
    }
    group(placed);
}

/// Finds a triangle of the original at each base vertex.
void InverseMap::note_base_vertices() {
    std::vector<Index> base_vertex(original_.positions.size(), no_index);
    for (Index b = 0; b < original_vertex_.size(); ++b)
        base_vertex[original_vertex_[b]] = b;
    for (Index t = 0; t < original_.triangles.size(); ++t)
        for (Index corner : original_.triangles[t])
            if (base_vertex[corner] != no_index)
                at_base_vertex_[base_vertex[corner]] = t;
}

/// Sorts the covers by their base triangles.
void InverseMap::group(const std::vector<Placed>& placed) {
    start_.assign(base_.triangles.size() + 1, 0);
    for (const Placed& p : placed)
        ++start_[p.base_triangle + 1];
    std::partial_sum(start_.begin(), start_.end(), start_.begin());
    covers_.resize(placed.size());
    std::vector<Index> at(start_.begin(), start_.end() - 1);
    for (const Placed& p : placed)
        covers_[at[p.base_triangle]++] = p.cover;
}

/// The cover with a corner at the point, else the one in which the point lies deepest. Images that are turned
/// over count only where there is no other.
InverseMap::Hit InverseMap::find(const SurfacePoint& base_point) const {
    Hit best{nullptr, Vec3::Zero()};
    double depth = -std::numeric_limits<double>::infinity();
    bool best_upright = false;
    const Vec2 p = base_point.barycentric.tail<2>();
    for (Index i = start_[base_point.triangle]; i < start_[base_point.triangle + 1]; ++i) {
        const Cover& cover = covers_[i];
        for (int k = 0; k < 3; ++k)
            if ((cover.images[k] - base_point.barycentric).cwiseAbs().maxCoeff() < same_place)
                return {&cover, Vec3::Unit(k)};
        const std::array<Vec2, 3> plane = in_plane(cover.images);
        Vec3 coordinates;
        if (!planar_coordinates(p, plane, coordinates))
            continue;
        const double least = coordinates.minCoeff();
        const bool upright = cross(plane[1] - plane[0], plane[2] - plane[0]) > 0;
        const bool better = least >= 0 && depth >= 0
                                ? std::pair(upright, least) > std::pair(best_upright, depth)
                                : least > depth;
        if (better) {
            best = {&cover, coordinates};
            depth = least;
            best_upright = upright;
        }
    }
    best.barycentric = best.barycentric.cwiseMax(0);
    if (const double sum = best.barycentric.sum(); sum > 0)
        best.barycentric /= sum;
    return best;
}

/// The corner of the base triangle nearest to the point, which is a vertex of the original.
SurfacePoint InverseMap::nearest_corner(const SurfacePoint& base_point) const {
    Eigen::Index nearest = 0;
    base_point.barycentric.maxCoeff(&nearest);
    const Index b = base_.triangles[base_point.triangle][static_cast<std::size_t>(nearest)];
    const Triangle& t = original_.triangles[at_base_vertex_[b]];
    return {at_base_vertex_[b], Vec3::Unit(std::find(t.begin(), t.end(), original_vertex_[b]) - t.begin())};
}

SurfacePoint InverseMap::locate(const SurfacePoint& base_point) const {
    if (base_point.barycentric.maxCoeff() > 1 - same_place)
        return nearest_corner(base_point);
    const Hit hit = find(base_point);
    return hit.cover ? SurfacePoint{hit.cover->triangle, hit.barycentric} : nearest_corner(base_point);
}

Vec3 InverseMap::to_surface(const SurfacePoint& base_point) const {
    const SurfacePoint at = locate(base_point); // with alpha, beta, gamma of eq. (2)
    return original_point(at.barycentric, corners_of(original_, at.triangle));
}

} // namespace wm3d::maps
