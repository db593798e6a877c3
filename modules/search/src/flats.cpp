// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/search/flats.hpp>

#include <algorithm>
#include <numeric>

#include <wm3d/mesh/measure.hpp>

namespace wm3d::search {

namespace {

constexpr std::size_t samples = 512;
constexpr std::size_t least_samples = 3; ///< of one plane face
/// How far from its plane a corner may lie, relative to the box's diagonal: of a plane that one triangle tells,
/// and of one that many do. Text with six digits strays by 1e-6.
constexpr double roughly = 1e-4, closely = 2e-5;

struct Plane {
    Vec3 point, normal;
};

Vec3 centre_of(const TriangleMesh& mesh, std::size_t f) {
    const auto& [a, b, c] = mesh.triangles[f];
    return (mesh.positions[a] + mesh.positions[b] + mesh.positions[c]) / 3;
}

bool lies_in(const TriangleMesh& mesh, std::size_t f, const Plane& plane, double tolerance) {
    const auto near = [&](Index v) {
        return std::abs(plane.normal.dot(mesh.positions[v] - plane.point)) <= tolerance;
    };
    return std::ranges::all_of(mesh.triangles[f], near) && area_vector(mesh, f).dot(plane.normal) > 0;
}

/// Triangles at even steps of the area.
std::vector<std::size_t> spread_evenly(const std::vector<double>& area, double whole) {
    std::vector<std::size_t> chosen; // a triangle larger than a step is there once for each
    double before = 0;
    for (std::size_t f = 0; f < area.size(); ++f) {
        before += area[f];
        while (chosen.size() < samples &&
               before > (static_cast<double>(chosen.size()) + 0.5) * whole / samples)
            chosen.push_back(f);
    }
    return chosen;
}

/// The plane through triangles of nearly one plane.
Plane mean_plane(const TriangleMesh& mesh, const std::vector<std::size_t>& triangles) {
    Plane plane{Vec3::Zero(), Vec3::Zero()};
    for (const std::size_t f : triangles) {
        plane.normal += area_vector(mesh, f);
        plane.point += centre_of(mesh, f) / static_cast<double>(triangles.size());
    }
    plane.normal.stableNormalize();
    return plane;
}

Flat measured(const TriangleMesh& mesh, const std::vector<double>& area, double whole, const Plane& plane,
              double tolerance) {
    Flat flat{0, Vec3::Zero(), plane.normal};
    for (std::size_t f = 0; f < area.size(); ++f)
        if (lies_in(mesh, f, plane, tolerance)) {
            flat.area += area[f] / whole;
            flat.centre += area[f] / whole * centre_of(mesh, f);
        }
    if (flat.area > 0)
        flat.centre /= flat.area;
    return flat;
}

} // namespace

std::vector<Flat> flats(const TriangleMesh& mesh) {
    const std::vector<double> area = triangle_areas(mesh);
    const double whole = std::accumulate(area.begin(), area.end(), 0.0);
    if (!(whole > 0))
        return {};
    const double diagonal = surface_box(mesh).diagonal();
    std::vector<std::size_t> left = spread_evenly(area, whole);
    std::vector<Flat> found;
    while (!left.empty()) {
        const Plane plane = mean_plane(mesh, {left.front()});
        std::vector<std::size_t> same, others;
        for (const std::size_t f : left)
            (f == left.front() || lies_in(mesh, f, plane, roughly * diagonal) ? same : others).push_back(f);
        left = std::move(others);
        if (same.size() >= least_samples)
            found.push_back(measured(mesh, area, whole, mean_plane(mesh, same), closely * diagonal));
    }
    std::ranges::stable_sort(found, std::greater{}, &Flat::area);
    return found;
}

Flat lone_flat(const TriangleMesh& mesh) {
    constexpr double least = 0.006, others = 0.25;
    const std::vector<Flat> all = flats(mesh);
    if (all.empty() || all.front().area < least)
        return {};
    double rest = 0;
    for (std::size_t k = 1; k < all.size(); ++k)
        rest += all[k].area;
    return rest < others * all.front().area ? all.front() : Flat{};
}

} // namespace wm3d::search
