// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  From a mesh and a key to the marked positions (section 2.2 of the paper).
#pragma once

#include <optional>

#include <wm3d/embed/embed.hpp>
#include <wm3d/maps/base_domain.hpp>
#include <wm3d/payload/sequence.hpp>
#include <wm3d/watermark/examination.hpp>

namespace wm3d::watermark {

/// How the strength is laid out.
enum class Profile {
    robust, ///< along the vertex normals, shaped for what the detector sees after attacks
    paper,  ///< the bumps themselves along the radius, eq. (3)
};

struct MarkOptions {
    Profile profile = Profile::robust;
    /// Area-weighted RMS of the move along the surface normal, % of the bounding box's diagonal.
    double strength = default_strength;
    std::optional<double> gamma;             ///< of eq. (3), instead of a strength; means the paper's profile
    std::size_t vertices = default_vertices; ///< of the base domain
    std::optional<unsigned> level;           ///< of the watermarking sphere; must be one of the key's
    std::optional<double> rmax;              ///< height of the bumps; the key's own if not given
    double pf = default_pf;                  ///< at which the mark has to be found again
    payload::Content content;                ///< what the mark says besides whose it is
};

struct Marked {
    std::vector<Vec3> positions; ///< #V, in the coordinates of the mesh
    Frame frame;
    std::size_t base_vertices = 0;
    Profile profile = Profile::robust;
    unsigned level = 0;
    double rmax = 0;
    double gamma = 0;             ///< of the bumps of the same strength
    double diagonal = 0;          ///< of the surface's bounding box, in units of the mesh
    embed::Distortion distortion; ///< in units of the mesh
};

/// What a mark of a secret depends on besides the mesh.
struct MarkSetting {
    unsigned level = 5;
    double rmax = 0.1;
    double strength = default_strength; ///< as in MarkOptions
    std::optional<double> gamma = std::nullopt;
    Profile profile = Profile::robust;
    payload::Content content = {};
};

/// A mesh made ready for marks: frame, base domain and details, which depend on no key. The mesh has to
/// outlive it.
class Marker {
public:
    /// \throw GeometryError  if the mesh has no area
    Marker(const TriangleMesh& mesh, std::size_t vertices, const Progress& progress = {});
    Marker(const Marker&) = delete;
    Marker& operator=(const Marker&) = delete;

    const maps::BaseDomain& domain() const { return domain_; } ///< in the canonical frame

    /// Moves of the base vertices and reconstruction. May be called from several threads.
    /// \throw GeometryError  if no radial move shows on the mesh
    Marked mark(const key::Secret& secret, const MarkSetting& setting) const;

private:
    std::vector<Vec3> bumpy_base(std::span<const double> delta, double gamma) const;
    std::vector<Vec3> shaped_base(std::span<const double> w, const MarkSetting& setting) const;
    double normal_rms(std::span<const Vec3> moved_base) const;

    const TriangleMesh& mesh_;
    Frame frame_;
    double diagonal_;
    TriangleMesh canonical_;
    maps::BaseDomain domain_;
    embed::DetailedMesh detailed_; ///< refers to `domain_`
};

/// Marks a mesh: base domain by MAPS, eq. (3) or a shaped mark on its vertices, reconstruction.
/// \throw ParameterError  if the key does not admit the level, or an option is out of range
/// \throw GeometryError   if the mesh has no area, or no radial move shows on it
Marked mark(const TriangleMesh& mesh, const key::Key& key, const MarkOptions& options = {},
            const Progress& progress = {});

/// What can be said before a file is written.
struct Forecast {
    double expected_sigmas = 0; ///< score of the unattacked mark in the best filter
    double predicted_miss = 1;  ///< at `pf`
};

/// What verify would find on the marked mesh, told from the unmarked one.
/// \throw GeometryError  if the mesh has no area
Forecast forecast(const TriangleMesh& mesh, const key::Key& key, const MarkOptions& options,
                  const Progress& progress = {});

/// Distortion in % of the bounding box's diagonal.
embed::Distortion percent(const embed::Distortion& distortion, double diagonal);

} // namespace wm3d::watermark
