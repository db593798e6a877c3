// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  From a mesh and a key to the marked positions (section 2.2 of the paper).
#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <span>
#include <string_view>

#include <wm3d/core/error.hpp>
#include <wm3d/embed/embed.hpp>
#include <wm3d/maps/base_domain.hpp>
#include <wm3d/masking/budget.hpp>
#include <wm3d/masking/carriers.hpp>
#include <wm3d/mesh/curve_order.hpp>
#include <wm3d/payload/sequence.hpp>
#include <wm3d/sphere/sparse_rows.hpp>
#include <wm3d/watermark/examination.hpp>

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
    resync::Ambiguity ambiguity = resync::Ambiguity::none; ///< of the frame
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

/// A mesh made ready for marks: whatever depends on no key is made once, when it is first needed. The mesh
/// has to outlive it.
class Marker {
public:
    /// \throw GeometryError  if the mesh has no area
    Marker(const TriangleMesh& mesh, std::size_t vertices, const Progress& progress = {});
    ~Marker();
    Marker(const Marker&) = delete;
    Marker& operator=(const Marker&) = delete;

    /// The base domain of the profiles robust and paper, in the canonical frame.
    const maps::BaseDomain& domain() const;

    /// The carriers of the profile masked, whose moves are linear in any sequence of the level.
    const masking::Carriers& carriers(unsigned level) const;

    /// May be called from several threads.
    /// \throw GeometryError  if no radial move shows on the mesh
    /// \throw TooVisible     if no mark keeps to the visibility
    Marked mark(const key::Secret& secret, const MarkSetting& setting) const;

    /// The mark of a sequence of the level's length, whatever it was made of; heights above rmax are as good
    /// as others, since strength and visibility set the scale.
    /// \throw ParameterError  if w has another length
    /// \throw GeometryError   if no radial move shows on the mesh
    Marked mark(std::span<const double> w, const MarkSetting& setting) const;

    /// One-sided MSDM2 of moved vertices, #V in the coordinates of the mesh.
    double visible(const std::vector<Vec3>& positions) const;

private:
    struct Base;
    struct Carried;
    struct Layout;
    struct Made;
    using Meanwhile = std::function<void(const Carried& with)>; ///< work that doesn't depend on the mask

    const TriangleMesh& canonical() const; ///< made at first need; `made_` has to be locked
    const Base& base() const;
    const masking::Budget& budget() const;
    const masking::Budget& made_budget() const; ///< `made_` has to be locked
    Carried fresh_carriers(unsigned level) const;
    const Carried& carried(unsigned level, const Meanwhile& meanwhile = {}) const;
    void weigh(Carried& carried, unsigned level) const; ///< `made_` has to be locked
    sphere::SparseRows rows(unsigned level, std::size_t begin, std::size_t end) const;
    std::vector<double> bumps(const Carried& with, unsigned level, std::span<const double> w) const;
    Layout masked(std::span<const double> w, unsigned level) const;
    Layout shaped(std::span<const double> w, unsigned level) const;
    Layout bumpy(std::span<const double> w, unsigned level) const;
    Layout layout(std::span<const double> w, Profile profile, unsigned level) const;
    double normal_rms(std::span<const Vec3> moved) const; ///< of the full canonical mesh, % of the diagonal
    double percent_of_diagonal(double radii) const;
    /// What was moved of the canonical mesh, which is there, in the coordinates of the mesh.
    std::vector<Vec3> in_file(std::span<const Vec3> moved) const;
    std::vector<Vec3> moved(const masking::Carriers& carriers, std::span<const double> moves,
                            double factor) const; ///< in the coordinates of the mesh

    void uncrease(Marked& marked, double visibility,
                  const std::optional<masking::WeightyWindows>& weighty) const;
    std::vector<Vec3> in_given_order(const std::vector<Vec3>& positions) const;

    Reordered sorted_;         ///< a mesh that is worth it; else empty
    const TriangleMesh& mesh_; ///< that is worked on: the one given or, if it is sorted, `sorted_`
    std::size_t vertices_;
    Progress progress_;
    ShapeMoments moments_;
    Frame frame_;
    double diagonal_;
    std::unique_ptr<Made> made_; ///< what was needed so far
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
