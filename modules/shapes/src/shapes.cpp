// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/shapes/shapes.hpp>

#include <algorithm>
#include <cmath>
#include <numbers>

#include <wm3d/mesh/weld.hpp>

#include "noise.hpp"

namespace wm3d::shapes {

namespace {

constexpr double pi = std::numbers::pi;

void add_quad(std::vector<Triangle>& triangles, Index a, Index b, Index c, Index d) {
    triangles.push_back({a, b, c});
    triangles.push_back({a, c, d});
}

/// Direction of the point of the sphere at latitude step i of `rings` and longitude step j of 2 `rings`.
Vec3 spherical(std::size_t i, std::size_t j, std::size_t rings) {
    const double theta = pi * static_cast<double>(i) / static_cast<double>(rings);
    const double phi = pi * static_cast<double>(j) / static_cast<double>(rings);
    return {std::sin(theta) * std::cos(phi), std::sin(theta) * std::sin(phi), std::cos(theta)};
}

} // namespace

TriangleMesh box(const Vec3& size, std::size_t n) {
    std::vector<Vec3> positions;
    std::vector<Triangle> triangles;
    for (int axis = 0; axis < 3; ++axis) {
        const int u = (axis + 1) % 3, v = (axis + 2) % 3;
        for (int side = 0; side < 2; ++side) {
            const auto base = static_cast<Index>(positions.size());
            for (std::size_t i = 0; i <= n; ++i)
                for (std::size_t j = 0; j <= n; ++j) {
                    Vec3 p;
                    p[axis] = side * size[axis];
                    p[u] = size[u] * static_cast<double>(i) / static_cast<double>(n);
                    p[v] = size[v] * static_cast<double>(j) / static_cast<double>(n);
                    positions.push_back(p);
                }
            const auto at = [&](std::size_t i, std::size_t j) {
                return base + static_cast<Index>(i * (n + 1) + j);
            };
            for (std::size_t i = 0; i < n; ++i)
                for (std::size_t j = 0; j < n; ++j) {
                    if (side == 1)
                        add_quad(triangles, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
                    else
                        add_quad(triangles, at(i, j), at(i, j + 1), at(i + 1, j + 1), at(i + 1, j));
                }
        }
    }
    return weld(positions, triangles).mesh;
}

TriangleMesh sphere(double radius, std::size_t rings) {
    return ellipsoid(Vec3::Constant(radius), rings);
}

TriangleMesh ellipsoid(const Vec3& semi_axes, std::size_t rings) {
    TriangleMesh mesh;
    const std::size_t around = 2 * rings;
    mesh.positions.push_back({0, 0, semi_axes[2]});
    for (std::size_t i = 1; i < rings; ++i)
        for (std::size_t j = 0; j < around; ++j)
            mesh.positions.push_back(spherical(i, j, rings).cwiseProduct(semi_axes));
    mesh.positions.push_back({0, 0, -semi_axes[2]});
    const auto south = static_cast<Index>(mesh.positions.size() - 1);
    const auto at = [&](std::size_t i, std::size_t j) {
        return static_cast<Index>(1 + (i - 1) * around + j % around);
    };
    for (std::size_t j = 0; j < around; ++j) {
        mesh.triangles.push_back({0, at(1, j), at(1, j + 1)});
        for (std::size_t i = 1; i + 1 < rings; ++i)
            add_quad(mesh.triangles, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
        mesh.triangles.push_back({south, at(rings - 1, j + 1), at(rings - 1, j)});
    }
    return mesh;
}

TriangleMesh torus(double major_radius, double minor_radius, std::size_t m, std::size_t n) {
    TriangleMesh mesh;
    for (std::size_t i = 0; i < m; ++i)
        for (std::size_t j = 0; j < n; ++j) {
            const double u = 2 * pi * static_cast<double>(i) / static_cast<double>(m);
            const double v = 2 * pi * static_cast<double>(j) / static_cast<double>(n);
            const double r = major_radius + minor_radius * std::cos(v);
            mesh.positions.push_back({r * std::cos(u), r * std::sin(u), minor_radius * std::sin(v)});
        }
    const auto at = [&](std::size_t i, std::size_t j) { return static_cast<Index>((i % m) * n + j % n); };
    for (std::size_t i = 0; i < m; ++i)
        for (std::size_t j = 0; j < n; ++j)
            add_quad(mesh.triangles, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    return mesh;
}

TriangleMesh square(double size, std::size_t n) {
    TriangleMesh mesh;
    const double step = size / static_cast<double>(n);
    for (std::size_t i = 0; i <= n; ++i)
        for (std::size_t j = 0; j <= n; ++j)
            mesh.positions.push_back({step * static_cast<double>(i), step * static_cast<double>(j), 0});
    const auto at = [&](std::size_t i, std::size_t j) { return static_cast<Index>(i * (n + 1) + j); };
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < n; ++j)
            add_quad(mesh.triangles, at(i, j), at(i + 1, j), at(i + 1, j + 1), at(i, j + 1));
    return mesh;
}

TriangleMesh blob(std::size_t vertices, std::uint64_t seed) {
    const auto rings = static_cast<std::size_t>(std::max(4.0, std::sqrt(static_cast<double>(vertices) / 2)));
    TriangleMesh mesh = sphere(1.0, rings);
    struct Wave {
        Vec3 direction;
        double phase, height;
    };
    std::vector<Wave> waves;
    for (double frequency : {1.5, 2.5, 4.0, 6.0, 9.0, 14.0})
        for (int k = 0; k < 4; ++k) {
            const Vec3 direction{signed_unit(seed), signed_unit(seed), signed_unit(seed)};
            waves.push_back({frequency * direction, pi * signed_unit(seed), 0.12 / (frequency * frequency)});
        }
    for (Vec3& p : mesh.positions) {
        double radius = 1;
        for (const Wave& wave : waves)
            radius += wave.height * std::sin(wave.direction.dot(p) * pi + wave.phase);
        p = (radius * p).cwiseProduct(Vec3{1.3, 1.0, 0.75});
    }
    return mesh;
}

} // namespace wm3d::shapes
