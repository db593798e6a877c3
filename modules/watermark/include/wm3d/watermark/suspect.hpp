// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  A mesh that a mark is looked for in, and what is known of it before any key: once, for all who ask.
#pragma once

#include <memory>
#include <vector>

#include <wm3d/core/progress.hpp>
#include <wm3d/mesh/frame.hpp>
#include <wm3d/resync/candidate_pose.hpp>
#include <wm3d/search/centres.hpp>
#include <wm3d/simplify/simplify.hpp>
#include <wm3d/watermark/defaults.hpp>

namespace wm3d::watermark {

/// What a surface says at all of its vertices.
struct WholeSurface {
    /// The axes of what the surface may be taken for.
    struct Axes {
        Substance substance = Substance::solid;
        Frame frame; ///< canonical_frame of the mesh as this substance
        std::vector<resync::CandidatePose> before_smoothing; ///< frames_before_smoothing
    };

    ShapeMoments moments;
    search::Outline outline;
    std::vector<Axes> axes; ///< of moments.possible_substances()
};

/// \throw GeometryError  if the mesh has no area
WholeSurface look_at_whole(const TriangleMesh& mesh);

/// A suspect and its base mesh, both in the suspect's own coordinates. The mesh has to outlive it.
struct Suspect {
    const TriangleMesh& mesh;
    TriangleMesh base;
    simplify::Stop stop = simplify::Stop::reached;
    double telling = 1; ///< part of its surface that is in the base and can show a mark: LargestParts
    std::shared_ptr<const WholeSurface> whole = nullptr; ///< where it was looked at

    /// That, or a fresh look.
    std::shared_ptr<const WholeSurface> whole_surface() const;
};

/// The base alone. Of a mesh of so many parts that simplification leaves more than 60,000 vertices, the largest parts are
/// kept.
Suspect simplify_suspect(const TriangleMesh& mesh, std::size_t vertices, const Progress& progress = {});

/// The base, and the whole surface, which is looked at meanwhile.
/// \throw GeometryError  if the mesh has no area
Suspect prepare_suspect(const TriangleMesh& mesh, std::size_t vertices, const Progress& progress = {});

} // namespace wm3d::watermark
