// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Closed and open surfaces with known areas, genus and boundaries.
#pragma once

#include <cstddef>
#include <cstdint>

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::shapes {

/// Surface of the box [0, size] with each side cut into n by n squares of two triangles; closed, with
/// creases.
/// \pre  n > 0
TriangleMesh box(const Vec3& size, std::size_t n);

/// Sphere about the origin by `rings` parallels and 2 `rings` meridians; closed.
/// \pre  rings >= 2
TriangleMesh sphere(double radius, std::size_t rings);

/// Ellipsoid about the origin with the given semi-axes, meshed as `sphere`.
TriangleMesh ellipsoid(const Vec3& semi_axes, std::size_t rings);

/// Torus about the z axis, m steps around it and n around the tube; closed, genus 1, not star-shaped.
/// \pre  m, n >= 3
TriangleMesh torus(double major_radius, double minor_radius, std::size_t m, std::size_t n);

/// Flat square [0, size]^2 in z = 0, n by n cells; one boundary loop.
/// \pre  n > 0
TriangleMesh square(double size, std::size_t n);

/// A bumpy closed blob of about `vertices` vertices: an ellipsoid with smooth waves of several lengths; same
/// seed, same shape. Stands in for a scan in tests.
TriangleMesh blob(std::size_t vertices, std::uint64_t seed);

} // namespace wm3d::shapes
