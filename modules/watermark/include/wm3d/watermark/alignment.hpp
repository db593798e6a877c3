// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Poses that a receipt or a reference tells, and the evidence that a reference gives.
#pragma once

#include <optional>
#include <vector>

#include <wm3d/resync/receipt.hpp>
#include <wm3d/resync/registration.hpp>
#include <wm3d/resync/surface_difference.hpp>
#include <wm3d/watermark/examination.hpp>

namespace wm3d::watermark {

/// What is known of a suspect's pose besides its own shape.
struct KnownPose {
    std::vector<resync::CandidatePose> poses;
    std::optional<resync::Registration> registration; ///< where one was asked for
};

/// The frame of the receipt as it stands, where the suspect lies around it, and, if `align`, the one that
/// registration against its template finds.
/// \throw ParameterError if this build can't register
KnownPose pose_by_receipt(const resync::Receipt& receipt, const Suspect& suspect, bool align,
                          const Progress& progress = {});

/// A reference in its canonical frame, and a suspect's difference from it.
struct ReferenceView {
    KnownPose known;   ///< the one pose that registration finds; none if it fails
    TriangleMesh mesh; ///< reference, simplified, in its canonical frame; empty if registration fails
    resync::SurfaceDifference difference;
};

/// Aligns the suspect with a reference and subtracts the reference surface.
/// \throw GeometryError   if the reference has no area
/// \throw ParameterError  if this build can't register
ReferenceView compare_with_reference(const TriangleMesh& reference, const Suspect& suspect,
                                     const Progress& progress = {});

/// One hypothesis per level from the difference, in the coordinates of `view` and the last pose of the
/// examination. None where nothing was aligned.
std::vector<detect::Hypothesis> reference_family(const ReferenceView& view, const Examination& examination);

} // namespace wm3d::watermark
