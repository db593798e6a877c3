// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/shapes/sample.hpp>

#include <algorithm>
#include <array>
#include <cmath>
#include <numbers>

#include <fmt/format.h>

#include <wm3d/core/error.hpp>
#include <wm3d/shapes/contour.hpp>

#include "noise.hpp"

namespace wm3d::shapes {

namespace {

// The ewer is modelled two units tall and leaves in millimetres.
constexpr double millimetres = 150;

/// 0 below `low`, 1 above `high`, smooth between.
double smooth_step(double low, double high, double x) {
    const double t = std::clamp((x - low) / (high - low), 0.0, 1.0);
    return t * t * (3 - 2 * t);
}

/// Union with a fillet of about the given radius.
double smooth_union(double a, double b, double radius) {
    const double h = std::max(radius - std::abs(a - b), 0.0) / radius;
    return std::min(a, b) - h * h * radius / 4;
}

double box_distance(const Vec3& p, const Vec3& centre, const Vec3& half) {
    const Vec3 q = (p - centre).cwiseAbs() - half;
    return q.cwiseMax(0.0).norm() + std::min(q.maxCoeff(), 0.0);
}

/// Radius of the body at height z: a cubic through the points with slopes from their neighbours.
double profile(double z) {
    static constexpr std::array<std::array<double, 2>, 11> points{{{0.10, 0.215},
                                                                   {0.22, 0.200},
                                                                   {0.32, 0.125},
                                                                   {0.42, 0.135},
                                                                   {0.62, 0.290},
                                                                   {0.86, 0.385},
                                                                   {1.10, 0.355},
                                                                   {1.32, 0.215},
                                                                   {1.50, 0.135},
                                                                   {1.72, 0.145},
                                                                   {2.00, 0.235}}};
    z = std::clamp(z, points.front()[0], points.back()[0] - 1e-9);
    std::size_t i = 0;
    while (points[i + 1][0] <= z)
        ++i;
    const auto slope = [&](std::size_t k) {
        const auto& a = points[k == 0 ? 0 : k - 1];
        const auto& b = points[std::min(k + 1, points.size() - 1)];
        return (b[1] - a[1]) / (b[0] - a[0]);
    };
    const double width = points[i + 1][0] - points[i][0], t = (z - points[i][0]) / width;
    return (2 * t * t * t - 3 * t * t + 1) * points[i][1] + (t * t * t - 2 * t * t + t) * width * slope(i) +
           (3 * t * t - 2 * t * t * t) * points[i + 1][1] + (t * t * t - t * t) * width * slope(i + 1);
}

/// Distance bound to the solid of revolution about z, flattened along y; `inset` shrinks it.
double revolved(const Vec3& p, double inset, double groove) {
    constexpr double flattening = 0.82;
    const double radius = std::hypot(p.x(), p.y() / flattening);
    const double step = 1e-4;
    const double steepness = (profile(p.z() + step) - profile(p.z() - step)) / (2 * step);
    return flattening * (radius - profile(p.z()) + inset + groove) / std::sqrt(1 + steepness * steepness);
}

/// Helical gadroons on the belly: round ribs with sharp valleys between them.
double gadroons(const Vec3& p) {
    constexpr double ribs = 18, twist = 2.6, depth = 0.018;
    const double phase = 0.5 * ribs * std::atan2(p.y(), p.x()) + twist * p.z();
    const double fade = smooth_step(0.48, 0.62, p.z()) * (1 - smooth_step(1.06, 1.20, p.z()));
    return depth * fade * (1 - std::abs(std::sin(phase)));
}

/// Height of the rim: the spout, on the side away from the handle, rises.
double rim_height(const Vec3& p) {
    return 1.82 + 0.13 * smooth_step(0.02, 0.26, -p.x());
}

/// The spout's lip: a pinch of the mouth towards -x.
Vec3 pinch(const Vec3& p) {
    const double high = smooth_step(1.55, 1.95, p.z());
    return {p.x() + 0.10 * high * smooth_step(0.0, 0.25, -p.x()),
            p.y() * (1 + 0.45 * high * smooth_step(0, 0.3, -p.x())), p.z()};
}

double vessel(const Vec3& p, double wall) {
    const Vec3 pinched = pinch(p);
    const double rim = p.z() - rim_height(p);
    const double foot = 0.10 - p.z();
    const double outside = std::max({revolved(pinched, 0, gadroons(p)) / 1.35, rim, foot});
    // The neck is hollow down to the shoulder, as deep as a scanner sees.
    const double cavity = std::max(revolved(pinched, wall, 0) / 1.35, 1.38 - p.z());
    return std::max(outside, -cavity);
}

Vec3 handle_point(double t) {
    static const std::array<Vec3, 4> control{Vec3(0.30, 0, 1.08), Vec3(0.86, 0, 1.22), Vec3(0.64, 0, 2.16),
                                             Vec3(0.13, 0, 1.72)};
    const double s = 1 - t;
    return s * s * s * control[0] + 3 * s * s * t * control[1] + 3 * s * t * t * control[2] +
           t * t * t * control[3];
}

/// A strap with sharp edges along a plane curve, wider at its root; thin across.
double handle(const Vec3& p, double thickness) {
    constexpr int pieces = 40;
    const double away = box_distance(p, {0.38, 0, 1.50}, {0.34, 0.10, 0.52});
    if (away > 0.2) // far off, the box around it is bound enough
        return away;
    double nearest = std::numeric_limits<double>::infinity(), t_nearest = 0;
    for (int piece = 0; piece < pieces; ++piece) {
        const double t0 = piece / double(pieces);
        const Vec3 a = handle_point(t0), b = handle_point(t0 + 1.0 / pieces);
        const Vec3 flat(p.x(), 0, p.z());
        const double s = std::clamp((flat - a).dot(b - a) / (b - a).squaredNorm(), 0.0, 1.0);
        if (const double d = (flat - a - s * (b - a)).norm(); d < nearest) {
            nearest = d;
            t_nearest = t0 + s / pieces;
        }
    }
    const double half_width = 0.075 - 0.03 * smooth_step(0.0, 0.6, t_nearest);
    const double across = nearest - 0.5 * thickness, along = std::abs(p.y()) - half_width;
    return std::min(std::max(across, along), 0.0) + std::hypot(std::max(across, 0.0), std::max(along, 0.0));
}

/// Two square steps, one corner of the lower one broken off.
double plinth(const Vec3& p) {
    const double lower = box_distance(p, {0.03, 0, 0.05}, {0.36, 0.29, 0.05});
    const double upper = box_distance(p, {0.0, 0, 0.14}, {0.275, 0.225, 0.05});
    const Vec3 break_normal = Vec3(0.62, -0.55, 0.56).normalized();
    const double broken = break_normal.dot(p - Vec3(0.37, -0.27, 0.08));
    return std::min(std::max(lower, broken), upper);
}

/// The whole ewer; parts thinner than `thinnest` are made that thick.
double ewer(const Vec3& p, double thinnest) {
    const double body = vessel(p, std::max(0.034, thinnest));
    const double with_handle = smooth_union(body, handle(p, std::max(0.05, thinnest)), 0.04);
    // The fillet must not close the mouth: the cavity is cut again through the handle's root.
    const double cavity = std::max(revolved(pinch(p), std::max(0.034, thinnest), 0) / 1.35, 1.38 - p.z());
    return std::min(std::max(with_handle, -cavity), plinth(p));
}

/// What wear, tool marks and the scanner leave: a few thousandths of the height, rougher at smaller scales.
void add_relief(TriangleMesh& mesh, std::uint64_t seed) {
    const std::vector<Vec3> normals = vertex_normals(mesh);
    for (std::size_t v = 0; v < mesh.positions.size(); ++v) {
        const Vec3& p = mesh.positions[v];
        double height = 0, size = 0.0030;
        std::uint64_t octave = 0;
        for (const double frequency : {5.0, 11.0, 23.0, 47.0}) {
            height += size * gradient_noise(frequency * p, seed + octave++);
            size *= 0.55;
        }
        mesh.positions[v] += height * normals[v];
    }
}

TriangleMesh contour_ewer(double cell, int relaxation_sweeps) {
    const Box box{Vec3(-0.47, -0.45, -0.13), Vec3(0.90, 0.45, 2.15)};
    const Solid solid = [cell](const Vec3& p) { return ewer(p, 3 * cell); };
    return contour(solid, box, {.cell = cell, .relaxation_sweeps = relaxation_sweeps});
}

/// Triangles grow with the inverse square of the cell: two coarse runs are enough to meet the number.
double cell_for(std::size_t faces) {
    double cell = 0.04;
    for (int run = 0; run < 2; ++run) {
        const auto found = static_cast<double>(contour_ewer(cell, 0).triangles.size());
        cell = std::max(cell * std::sqrt(found / static_cast<double>(faces)), run == 0 ? 0.018 : 0.0);
    }
    return cell;
}

} // namespace

TriangleMesh sample(std::size_t faces, std::uint64_t seed) {
    if (faces < sample_min_faces || faces > sample_max_faces)
        throw ParameterError(fmt::format("the sample can have {} to {} faces, not {}", sample_min_faces,
                                         sample_max_faces, faces));
    TriangleMesh mesh = contour_ewer(cell_for(faces), 8);
    add_relief(mesh, seed);
    for (Vec3& p : mesh.positions)
        p *= millimetres;
    return mesh;
}

} // namespace wm3d::shapes
