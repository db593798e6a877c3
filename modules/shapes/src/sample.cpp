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
    struct Knot {
        double height, radius;
        double slope = 0;
    };
    static const std::array<Knot, 11> knots = [] {
        std::array<Knot, 11> k{{{0.10, 0.215},
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
        for (std::size_t i = 0; i < k.size(); ++i) {
            const Knot& a = k[i == 0 ? 0 : i - 1];
            const Knot& b = k[std::min(i + 1, k.size() - 1)];
            k[i].slope = (b.radius - a.radius) / (b.height - a.height);
        }
        return k;
    }();
    z = std::clamp(z, knots.front().height, knots.back().height - 1e-9);
    std::size_t i = 0;
    while (knots[i + 1].height <= z)
        ++i;
    const Knot &low = knots[i], &high = knots[i + 1];
    const double width = high.height - low.height, t = (z - low.height) / width;
    return (2 * t * t * t - 3 * t * t + 1) * low.radius + (t * t * t - 2 * t * t + t) * width * low.slope +
           (3 * t * t - 2 * t * t * t) * high.radius + (t * t * t - t * t) * width * high.slope;
}

/// The solid of revolution about z, flattened along y, as a point sees it.
class Revolved {
public:
    explicit Revolved(const Vec3& p) {
        constexpr double step = 1e-4;
        const double steepness = (profile(p.z() + step) - profile(p.z() - step)) / (2 * step);
        beyond_ = std::hypot(p.x(), p.y() / flattening) - profile(p.z());
        slant_ = std::sqrt(1 + steepness * steepness);
    }

    /// Distance bound; `inset` shrinks the solid.
    double distance(double inset, double groove) const {
        return flattening * (beyond_ + inset + groove) / slant_;
    }

private:
    static constexpr double flattening = 0.82;
    double beyond_, slant_;
};

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

struct Vessel {
    double solid;
    double cavity; ///< that is cut out of the solid
};

Vessel vessel(const Vec3& p, double wall) {
    const Revolved pinched(pinch(p));
    const double rim = p.z() - rim_height(p);
    const double foot = 0.10 - p.z();
    const double outside = std::max({pinched.distance(0, gadroons(p)) / 1.35, rim, foot});
    // The neck is hollow down to the shoulder, as deep as a scanner sees.
    const double cavity = std::max(pinched.distance(wall, 0) / 1.35, 1.38 - p.z());
    return {std::max(outside, -cavity), cavity};
}

Vec3 handle_point(double t) {
    static const std::array<Vec3, 4> control{Vec3(0.30, 0, 1.08), Vec3(0.86, 0, 1.22), Vec3(0.64, 0, 2.16),
                                             Vec3(0.13, 0, 1.72)};
    const double s = 1 - t;
    return s * s * s * control[0] + 3 * s * s * t * control[1] + 3 * s * t * t * control[2] +
           t * t * t * control[3];
}

/// The curve of the handle, cut into straight pieces.
struct HandlePiece {
    double t; ///< parameter of its beginning
    Vec3 begin, along;
    double squared_length;
};
constexpr int handle_pieces = 40;

const std::array<HandlePiece, handle_pieces>& handle_curve() {
    static const std::array<HandlePiece, handle_pieces> curve = [] {
        std::array<HandlePiece, handle_pieces> pieces;
        for (int k = 0; k < handle_pieces; ++k) {
            const double t = k / double(handle_pieces);
            const Vec3 a = handle_point(t), b = handle_point(t + 1.0 / handle_pieces);
            pieces[static_cast<std::size_t>(k)] = {t, a, b - a, (b - a).squaredNorm()};
        }
        return pieces;
    }();
    return curve;
}

/// How far p is from a box that holds the whole handle.
double handle_box(const Vec3& p) {
    return box_distance(p, {0.38, 0, 1.50}, {0.34, 0.10, 0.52});
}

/// A strap with sharp edges along a plane curve, wider at its root; thin across.
/// \param away  handle_box(p)
double handle(const Vec3& p, double thickness, double away) {
    if (away > 0.2) // far off, the box around it is bound enough
        return away;
    const Vec3 flat(p.x(), 0, p.z());
    double nearest_squared = std::numeric_limits<double>::infinity(), t_nearest = 0;
    for (const HandlePiece& piece : handle_curve()) {
        const Vec3 from = flat - piece.begin;
        const double s = std::clamp(from.dot(piece.along) / piece.squared_length, 0.0, 1.0);
        const double squared = (from - s * piece.along).squaredNorm();
        if (squared < nearest_squared) {
            nearest_squared = squared;
            t_nearest = piece.t + s / handle_pieces;
        }
    }
    const double half_width = 0.075 - 0.03 * smooth_step(0.0, 0.6, t_nearest);
    const double across = std::sqrt(nearest_squared) - 0.5 * thickness, along = std::abs(p.y()) - half_width;
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
    constexpr double fillet = 0.04;
    const auto [body, cavity] = vessel(p, std::max(0.034, thinnest));
    // Where the box around the handle is too far for the fillet, so is the handle.
    const double away = handle_box(p);
    const double with_handle = away > body + 1.01 * fillet
                                   ? body
                                   : smooth_union(body, handle(p, std::max(0.05, thinnest), away), fillet);
    // The fillet must not close the mouth: the cavity is cut again through the handle's root.
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
