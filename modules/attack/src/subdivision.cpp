// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/attack/resampling.hpp>

#include <cmath>
#include <string>

#include <wm3d/core/error.hpp>

#include "midpoint.hpp"
#include "openmesh_subdivision.hpp"

namespace wm3d::attack {

namespace {

constexpr double most_triangles = 50e6;

} // namespace

TriangleMesh subdivide(const TriangleMesh& mesh, SubdivisionScheme scheme, int steps) {
    const double growth = scheme == SubdivisionScheme::sqrt3 ? 3 : 4;
    const double triangles = static_cast<double>(mesh.triangles.size()) * std::pow(growth, steps);
    if (triangles > most_triangles)
        throw GeometryError("subdividing " + std::to_string(mesh.triangles.size()) + " triangles " +
                            std::to_string(steps) +
                            " times would make more than 50 million; take fewer steps");
    switch (scheme) {
    case SubdivisionScheme::sqrt3:
        return subdivide_sqrt3(mesh, steps);
    case SubdivisionScheme::loop:
        return subdivide_loop(mesh, steps);
    case SubdivisionScheme::midpoint:
        break;
    }
    TriangleMesh result = mesh;
    for (int step = 0; step < steps; ++step)
        result = subdivide_midpoint(result);
    return result;
}

} // namespace wm3d::attack
