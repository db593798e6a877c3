// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Faces with any number of corners, and their triangulation for the analysis.
#pragma once

#include <cstddef>
#include <span>
#include <vector>

#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::io {

/// Faces as one array of corners and the end of each face in it.
struct Polygons {
    std::vector<Index> corners;
    std::vector<std::size_t> ends;

    void close_face() { ends.push_back(corners.size()); }
    std::size_t size() const { return ends.size(); }
};

/// Triangles of all faces, in order. A face is cut into a fan from its first corner if all triangles of the
/// fan look the same way; otherwise (concave) ears are clipped in the plane of its area vector. Beyond 256
/// corners it is always a fan, which keeps the time linear.
/// \pre  all corners are numbers of `positions`
std::vector<Triangle> triangulate(std::span<const Vec3> positions, const Polygons& polygons);

/// Triangles of a strip: every other one turned so that all look the same way.
void append_strip(std::span<const Index> strip, std::vector<Triangle>& triangles);

} // namespace wm3d::io
