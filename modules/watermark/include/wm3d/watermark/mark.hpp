// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  From a mesh and a key to the marked positions (section 2.2 of the paper).
#pragma once

#include <functional>
#include <optional>
#include <span>
#include <vector>

#include <wm3d/core/error.hpp>
#include <wm3d/core/progress.hpp>
#include <wm3d/embed/embed.hpp>
#include <wm3d/key/key_file.hpp>
#include <wm3d/mesh/frame.hpp>
#include <wm3d/payload/sequence.hpp>
#include <wm3d/resync/hierarchical_frame.hpp>
#include <wm3d/watermark/defaults.hpp>

namespace wm3d::watermark {

/// No mark keeps to the visibility that was asked for, however weak.
class TooVisible : public GeometryError {
public:
    using GeometryError::GeometryError;
};

struct MarkOptions {
    Profile profile = Profile::masked;
    /// One-sided MSDM2 that the mark keeps to, in (0, 1], where no strength or gamma is given.
    double visibility = default_visibility;
    /// Area-weighted RMS of the move along the surface normal, % of the bounding box's diagonal.
    std::optional<double> strength;
    std::optional<double> gamma;             ///< of eq. (3), instead; means the paper's profile
    std::size_t vertices = default_vertices; ///< of the base domain, where the profile has one
    std::optional<unsigned> level;           ///< of the watermarking sphere; must be one of the key's
    std::optional<double> rmax;              ///< height of the bumps; the key's own if not given
    double pf = default_pf;                  ///< at which the mark has to be found again
    payload::Content content;                ///< what the mark says besides whose it is
    payload::Shares shares;                  ///< of its energy; detectors don't need to know them
};

struct Marked {
    std::vector<Vec3> positions; ///< #V, in the coordinates of the mesh
    Frame frame;
    resync::Ambiguity ambiguity =
        resync::Ambiguity::none;   ///< of the shape, so of the frame: a rotated copy may need a receipt
    std::size_t base_vertices = 0; ///< that carry the mark: of the base domain, or all of them
    Profile profile = Profile::masked;
    unsigned level = 0;
    double rmax = 0;
    double strength = 0;          ///< asked for or found, % of the diagonal
    double gamma = 0;             ///< of the bumps of the same strength
    double diagonal = 0;          ///< of the surface's bounding box, in units of the mesh
    embed::Distortion distortion; ///< in units of the mesh
    std::optional<double> msdm2;  ///< one-sided, of the marked mesh against the mesh, where it was measured
    bool seen_by_few = false;     ///< whether few vertices decide `msdm2`, where a visibility was kept to
};

/// What a mark of a sequence depends on besides the mesh. gamma goes before visibility, visibility before
/// strength.
struct MarkSetting {
    unsigned level = 5;
    double rmax = 0.1;
    double strength = default_strength; ///< % of the diagonal, as in MarkOptions
    std::optional<double> gamma = std::nullopt;
    Profile profile = Profile::robust;
    payload::Content content = {};
    payload::Shares shares = {};
    std::optional<double> visibility = std::nullopt; ///< MSDM2 to keep to, as in MarkOptions
};

/// Positions as a file will hold them, #V.
using Stored = std::function<std::vector<Vec3>(std::span<const Vec3> positions)>;

/// What these options ask a Marker of the mesh for.
/// \throw ParameterError  if the key does not admit the level, or the visibility is out of range
MarkSetting mark_setting(const TriangleMesh& mesh, const key::Key& key, const MarkOptions& options);

/// Marks a mesh: masked moves of all vertices or, on a base domain by MAPS, eq. (3) or a shaped mark and
/// reconstruction. MSDM2 is measured in any case.
/// \param stored  where it is given, and few vertices decide what is seen, the visibility is kept to by the
///     positions that it makes
/// \throw ParameterError  if the key does not admit the level, or an option is out of range
/// \throw GeometryError   if the mesh has no area, or no radial move shows on it
/// \throw TooVisible      if no mark keeps to the visibility
Marked mark(const TriangleMesh& mesh, const key::Key& key, const MarkOptions& options = {},
            const Progress& progress = {}, const Stored& stored = {});

/// Distortion in % of the bounding box's diagonal.
embed::Distortion percent(const embed::Distortion& distortion, double diagonal);

} // namespace wm3d::watermark
