// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Where the sphere's centre may be, the likeliest places first.
#pragma once

#include <cstddef>
#include <vector>

#include <wm3d/mesh/frame.hpp>
#include <wm3d/mesh/triangle_mesh.hpp>

namespace wm3d::search {

/// A suspect as the search for its centre sees it.
struct Outline {
    Vec3 centroid = Vec3::Zero(); ///< of the solid, or of the surface where that encloses little
    double radius = 1;            ///< mean distance of the surface from it
    /// Unit vector from the centroid towards the openings' mean place: what was cut away lay beyond. Where they
    /// lie about the centroid, out of them. Zero if there is no opening to speak of.
    Vec3 outwards = Vec3::Zero();
    double opening = 0; ///< area that would close the largest border, relative to the surface
    /// The same of the largest border that ends a limb: the surface runs towards it and not around it, as where a
    /// limb was cut through. The holes that scanners leave lie in a surface that goes on around them.
    double stump = 0;
    /// The same of a plane face in a surface that is nowhere else plane: it may close a cut.
    double closed = 0;
};

/// \throw GeometryError  if the mesh has no area
Outline outline(const TriangleMesh& mesh);

/// The substance whose centroid an outline has: the solid where it encloses something, as the cone to its centroid closes
/// what was cut.
Substance outlined(const ShapeMoments& moments);

/// The same of a mesh whose moments are known, and its mean radius about the centroid.
Outline outline(const TriangleMesh& mesh, const ShapeMoments& moments, double radius);

struct CentreOptions {
    double covering = 0.03; ///< farthest that any place is from a centre, in mean radii, near the centroid
    double least_opening = 0.002; ///< relative area from which an opening tells a direction
    double least_stump = 0.0005;  ///< the same of a stump; any plane face that may close a cut tells one
    double wide = 0.6; ///< angle from the opening's axis at which a place counts as twice as far, radians
};

/// The first `count` places of a body-centred cubic lattice around the centroid, in the coordinates of the
/// mesh. Places count as farther away the more they lie aside of the opening. Farther out, where directions
/// change more slowly with the centre, the lattice is wider.
std::vector<Vec3> centres(const Outline& outline, std::size_t count, const CentreOptions& options = {});

} // namespace wm3d::search
