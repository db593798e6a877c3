// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/search/centres.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <wm3d/mesh/measure.hpp>
#include <wm3d/mesh/topology.hpp>
#include <wm3d/search/flats.hpp>

namespace wm3d::search {

namespace {

struct Place {
    double distance; ///< as it counts
    Vec3 at;
};

/// Distance in the warped lattice times 1 + (angle / wide)^2.
double counted(const Vec3& u, const Vec3& outwards, double wide) {
    const double distance = u.norm();
    if (!(distance > 0) || outwards.isZero())
        return distance;
    const double angle = std::acos(std::clamp(u.dot(outwards) / distance, -1.0, 1.0));
    return distance * (1 + angle * angle / (wide * wide));
}

/// Lattice points that count as at most `limit` away, up to what memory is good for.
std::vector<Place> places_within(double limit, double edge, const Vec3& outwards, double wide) {
    std::vector<Place> places;
    const auto n = static_cast<int>(std::ceil(limit / edge));
    for (int x = -n; x <= n; ++x)
        for (int y = -n; y <= n; ++y)
            for (int z = -n; z <= n; ++z)
                for (const double half : {0.0, 0.5}) {
                    const Vec3 u = edge * Vec3(x + half, y + half, z + half);
                    if (const double distance = counted(u, outwards, wide); distance <= limit)
                        places.push_back({distance, u});
                }
    return places;
}

/// Borders whose rim is less flat than this end a limb, or a patch by itself where it is flat and negative. The
/// flattest of the cuts through legs, ears and horns has 0.5, the least flat of the bunny's five holes 0.65
/// (after simplification; docs/algorithm.md, section 9).
constexpr double flat_rim = 0.55;

/// What an opening tells of where something is missing: little if the surface goes on around it.
double weight(const BorderLoop& loop) {
    constexpr double least = 0.02; // for a lone cap that was cut off a sphere
    return loop.opening.norm() * std::max(least, 1 - loop.flatness());
}

} // namespace

Outline outline(const TriangleMesh& mesh) {
    const ShapeMoments moments = shape_moments(mesh);
    return outline(mesh, moments, mean_radius(mesh, moments.of(outlined(moments)).centroid));
}

Substance outlined(const ShapeMoments& moments) {
    return moments.solid.sphericity > 0.003 ? Substance::solid : Substance::surface;
}

Outline outline(const TriangleMesh& mesh, const ShapeMoments& moments, double radius) {
    Outline result;
    result.centroid = moments.of(outlined(moments)).centroid;
    result.radius = radius;
    double all = 0;
    Vec3 out = Vec3::Zero(), there = Vec3::Zero(); // of weights, and of weights times places
    for (const BorderLoop& loop : border_loops(mesh)) {
        const double area = loop.opening.norm() / moments.surface.area, w = weight(loop);
        result.opening = std::max(result.opening, area);
        if (std::abs(loop.flatness()) < flat_rim)
            result.stump = std::max(result.stump, area);
        all += w;
        out += w * loop.opening.stableNormalized();
        there += w * (loop.centre - result.centroid) / result.radius;
    }
    if (const Flat flat = lone_flat(mesh); flat.area > 0) {
        result.closed = flat.area;
        all += flat.area;
        out += flat.area * flat.normal;
        there += flat.area * (flat.centre - result.centroid) / result.radius;
    }
    constexpr double share_of_normal = 0.1; // enough where the places tell nothing
    const Vec3 axis = there + (moments.solid.volume < 0 ? -share_of_normal : share_of_normal) * out;
    if (all > 0 && axis.norm() > 0)
        result.outwards = axis.normalized();
    return result;
}

std::vector<Vec3> centres(const Outline& outline, std::size_t count, const CentreOptions& options) {
    if (count == 0)
        return {};
    const bool open = outline.opening >= options.least_opening || outline.stump >= options.least_stump ||
                      outline.closed > 0;
    const Vec3 outwards = open ? outline.outwards : Vec3::Zero();
    const double edge = options.covering * 4 / std::sqrt(5.0); // of a body-centred cubic lattice
    // The region's volume grows with the cube of its limit.
    double limit = edge * std::cbrt(3.0 * static_cast<double>(count) / (8 * std::numbers::pi));
    std::vector<Place> places = places_within(limit, edge, outwards, options.wide);
    while (places.size() < count) {
        limit *= 1.2;
        places = places_within(limit, edge, outwards, options.wide);
    }
    std::ranges::stable_sort(places, {}, &Place::distance);
    places.resize(count);
    std::vector<Vec3> result;
    result.reserve(count);
    for (const Place& place : places) {
        const double u = place.at.norm();
        const double stretch =
            u > 0 ? std::sinh(u) / u : 1; // dc/du = sqrt(1 + c^2), the mean distance from c
        result.push_back(outline.centroid + outline.radius * stretch * place.at);
    }
    return result;
}

} // namespace wm3d::search
