// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Registration of a suspect against a template of the surface it may come from.
#pragma once

#include <cstddef>
#include <string>

#include <wm3d/core/progress.hpp>
#include <wm3d/resync/pose_template.hpp>

namespace wm3d::resync {

struct RegistrationOptions {
    std::size_t suspect_points = 1500; ///< that judge how much of the suspect the template explains
    /// A point of the suspect is explained if the template's surface is no farther away, in mean radii of the
    /// template.
    double tolerance = 0.02;
    double least_coverage = 0.6; ///< of the suspect that has to be explained for an alignment
    double sure_coverage = 0.85; ///< from principal axes alone, which makes a search for cut copies needless
    double least_scale = 0.3;    ///< of the suspect's mean radius over that of the whole
    bool try_mirrored = true;    ///< look for mirror images where the suspect itself doesn't fit
    int iterations = 30;         ///< of the last and finest stage, at most
};

/// What a registration found.
struct Registration {
    bool aligned = false; ///< the suspect is explained well enough; if not, the transform means nothing
    Similarity transform; ///< from the template's coordinates to the suspect's; mirrors if the suspect is a
                          ///< mirror image
    double residual =
        0; ///< root mean square distance of matched points from the other surface, in mean radii
    double coverage = 0; ///< part of the suspect's surface that the template explains, 0 to 1
    /// Coverage less that of the best clearly different pose: near 0 on a sphere, whose pose nothing tells.
    double confidence = 0;
    std::size_t starts = 0; ///< poses that were refined
    bool searched = false;  ///< principal axes did not do, so pairs of points were matched
};

/// Whether this build can register at all (it needs Ceres).
bool has_registration();

/// Finds the similarity transform that lays the template on the suspect, or on the part of it that is left.
/// Starts are the four proper choices of principal axes; if none explains the suspect, pairs of oriented
/// points that look alike at any scale (after B. Drost, M. Ulrich, N. Navab, S. Ilic, "Model globally, match
/// locally", CVPR 2010). Each is refined by iterative closest points, point to plane (Y. Chen, G. Medioni
/// 1992), trimmed, with a robust loss.
/// \param suspect  best simplified: every query searches its triangles
/// \throw GeometryError if the suspect has no area
/// \throw ParameterError if this build can't register, or the template is empty
Registration register_template(const PoseTemplate& pose_template, const TriangleMesh& suspect,
                               const RegistrationOptions& options = {}, const Progress& progress = {});

} // namespace wm3d::resync
