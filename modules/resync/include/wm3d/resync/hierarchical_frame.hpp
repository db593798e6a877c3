// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The canonical frame found blind, by principal components on several levels of a simplification
/// hierarchy (the way to rotated copies that section 4 of the paper proposes as future work).
#pragma once

#include <string_view>
#include <vector>

#include <wm3d/core/progress.hpp>
#include <wm3d/mesh/triangle_mesh.hpp>
#include <wm3d/resync/candidate_pose.hpp>

namespace wm3d::resync {

struct HierarchyOptions {
    std::vector<std::size_t> levels{6000, 2000}; ///< vertices of the coarser levels, descending
    /// Relative change of the second moments that is reckoned with even where the levels agree better: what
    /// marks, roundings and light processing do.
    double least_change = 1e-4;
    /// Relative distance of two eigenvalues below which a shape counts as ambiguous: a change of the moments
    /// of a tenth of that turns the axes by 6 degrees.
    double ambiguous_gap = 0.01;
};

/// Least relative distance of two of three moments in descending order.
double least_gap(const Vec3& moments);

/// What the moments leave open.
enum class Ambiguity {
    none,  ///< three clearly different axes
    plane, ///< two equal moments: a body of revolution, a square prism
    all,   ///< three equal moments: a sphere, a cube
};

/// One sentence for people.
std::string_view describe(Ambiguity ambiguity);

/// What the moments of a shape leave open.
/// \param ambiguous_gap  as in HierarchyOptions
Ambiguity ambiguity_of(const CentralMoments& moments,
                       double ambiguous_gap = HierarchyOptions{}.ambiguous_gap);

/// Principal axes of one level.
struct LevelFrame {
    std::size_t vertices = 0;
    Mat3 axes = Mat3::Identity(); ///< rows, with the signs of the finest level's
    double change = 0;            ///< of the second moments against the finest level, relative
};

/// The frame of a mesh and how well its moments determine it.
struct FrameEstimate {
    Substance substance = Substance::solid; ///< whose moments these are
    Frame finest;                           ///< `canonical_frame` of the mesh itself
    Frame robust;                ///< median of the levels' rotations; centre and scale are the finest level's
    Vec3 moments = Vec3::Zero(); ///< eigenvalues, descending, in squared mean radii
    /// Turns about the three axes that the levels' disagreement allows, in degrees, 0 to 45.
    Vec3 uncertainty = Vec3::Zero();
    Ambiguity ambiguity = Ambiguity::none;
    std::vector<LevelFrame> levels; ///< finest first
};

/// The exact moments of a mesh and of coarser versions of it: computed once, for every substance.
struct Hierarchy {
    struct Level {
        TriangleMesh mesh;
        ShapeMoments moments;
    };
    ShapeMoments moments;       ///< of the mesh itself
    std::vector<Level> coarser; ///< finest first
};

/// \param base  a simplified version of the mesh, from which the coarser levels are made
/// \throw GeometryError  if the mesh has no area
Hierarchy make_hierarchy(const TriangleMesh& mesh, const TriangleMesh& base,
                         const HierarchyOptions& options = {}, const Progress& progress = {});

/// The same of a mesh whose moments are known.
Hierarchy make_hierarchy(const ShapeMoments& moments, const TriangleMesh& mesh, const TriangleMesh& base,
                         const HierarchyOptions& options = {}, const Progress& progress = {});

/// Estimates the frame of a mesh from its own exact moments and those of its coarser levels.
/// \param mesh  the mesh
/// \param base  a simplified version of it, from which the coarser levels are made
/// \throw GeometryError  if the mesh has no area
FrameEstimate estimate_frame(const TriangleMesh& mesh, const TriangleMesh& base,
                             const HierarchyOptions& options = {}, const Progress& progress = {});

/// The same for one substance of a mesh whose hierarchy is known.
FrameEstimate estimate_frame(const TriangleMesh& mesh, const Hierarchy& hierarchy, Substance substance,
                             const HierarchyOptions& options = {});

/// The same where its principal frame is known.
/// \param finest    canonical_frame of the mesh as this substance
/// \param vertices  of the mesh
FrameEstimate estimate_frame(const Frame& finest, std::size_t vertices, const Hierarchy& hierarchy,
                             Substance substance, const HierarchyOptions& options = {});

struct CandidateOptions {
    double step = 1.0;     ///< between neighbouring turns, in degrees: the detector bears half of it
    std::size_t most = 13; ///< frames, each of which is tried with all four choices of axis signs
};

/// The poses to try: the finest frame, the robust one where it differs, turns about each axis as wide as its
/// uncertainty, and quarter turns where two moments could change places; each with the four proper choices of
/// axis signs. The first is the finest frame itself. Depends on the mesh alone.
std::vector<CandidatePose> candidate_poses(const FrameEstimate& estimate,
                                           const CandidateOptions& options = {});

} // namespace wm3d::resync
