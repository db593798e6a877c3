// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  What the tests of the simplification share.
#pragma once

#include <algorithm>
#include <cstdint>
#include <numeric>
#include <utility>
#include <vector>

#include <wm3d/mesh.hpp>
#include <wm3d/simplify.hpp>

namespace wm3d::simplify::test {

inline TriangleMesh joined(const TriangleMesh& a, const TriangleMesh& b) {
    TriangleMesh mesh = a;
    const auto shift = static_cast<Index>(a.positions.size());
    mesh.positions.insert(mesh.positions.end(), b.positions.begin(), b.positions.end());
    for (const Triangle& t : b.triangles)
        mesh.triangles.push_back({t[0] + shift, t[1] + shift, t[2] + shift});
    return mesh;
}

inline TriangleMesh moved(TriangleMesh mesh, const Mat3& linear, const Vec3& shift) {
    for (Vec3& p : mesh.positions)
        p = linear * p + shift;
    return mesh;
}

/// 0, ..., n - 1 in an order that the seed decides.
inline std::vector<Index> shuffled(std::size_t n, std::uint64_t seed) {
    std::vector<Index> order(n);
    std::iota(order.begin(), order.end(), Index{0});
    for (std::size_t i = n; i > 1; --i) {
        seed = seed * 6364136223846793005u + 1442695040888963407u;
        std::swap(order[i - 1], order[(seed >> 33) % i]);
    }
    return order;
}

/// The same surface with vertices, triangles and the first corners of triangles in another order.
inline TriangleMesh reordered(const TriangleMesh& mesh, std::uint64_t seed) {
    const std::vector<Index> place = shuffled(mesh.positions.size(), seed);
    TriangleMesh result = mesh;
    for (Index v = 0; v < place.size(); ++v)
        result.positions[place[v]] = mesh.positions[v];
    const std::vector<Index> order = shuffled(mesh.triangles.size(), seed + 1);
    for (Index f = 0; f < order.size(); ++f) {
        Triangle t = mesh.triangles[f];
        std::rotate(t.begin(), t.begin() + f % 3, t.end());
        result.triangles[order[f]] = {place[t[0]], place[t[1]], place[t[2]]};
    }
    return result;
}

/// A strip of n squares around a circle that comes back turned by 180 degrees: one side, one boundary loop.
inline TriangleMesh moebius(std::size_t n, std::size_t width) {
    TriangleMesh mesh;
    const double pi = 3.14159265358979323846;
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j <= width; ++j) {
            const double u = 2 * pi * static_cast<double>(i) / static_cast<double>(n);
            const double w = static_cast<double>(j) / static_cast<double>(width) - 0.5;
            const double r = 2 + w * std::cos(u / 2);
            mesh.positions.push_back({r * std::cos(u), r * std::sin(u), w * std::sin(u / 2)});
        }
    const auto at = [&](std::size_t i, std::size_t j) {
        return static_cast<Index>(i < n ? i * (width + 1) + j : width - j);
    };
    for (std::size_t i = 0; i < n; ++i)
        for (std::size_t j = 0; j < width; ++j) {
            mesh.triangles.push_back({at(i, j), at(i + 1, j), at(i + 1, j + 1)});
            mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i, j + 1)});
        }
    return mesh;
}

/// Three half-planes that meet in a line: `n` edges of three triangles.
inline TriangleMesh three_pages(std::size_t n) {
    TriangleMesh mesh;
    std::vector<std::vector<Index>> page(3);
    for (std::size_t i = 0; i <= n; ++i)
        mesh.positions.push_back({0, 0, static_cast<double>(i)});
    const Vec3 direction[3] = {{1, 0, 0}, {-0.5, 0.9, 0}, {-0.5, -0.9, 0}};
    for (const Vec3& d : direction) {
        const auto base = static_cast<Index>(mesh.positions.size());
        for (std::size_t j = 1; j <= n; ++j)
            for (std::size_t i = 0; i <= n; ++i)
                mesh.positions.push_back(static_cast<double>(j) * d + Vec3{0, 0, static_cast<double>(i)});
        const auto at = [&](std::size_t i, std::size_t j) {
            return static_cast<Index>(j == 0 ? i : base + (j - 1) * (n + 1) + i);
        };
        for (std::size_t i = 0; i < n; ++i)
            for (std::size_t j = 0; j < n; ++j) {
                mesh.triangles.push_back({at(i, j), at(i, j + 1), at(i + 1, j + 1)});
                mesh.triangles.push_back({at(i, j), at(i + 1, j + 1), at(i + 1, j)});
            }
    }
    return mesh;
}

} // namespace wm3d::simplify::test
