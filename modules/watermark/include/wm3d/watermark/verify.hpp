// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  From a suspect and a key to a verdict.
#pragma once

#include <cstdint>
#include <optional>
#include <string>

#include <wm3d/detect/verdict.hpp>
#include <wm3d/payload/reading.hpp>
#include <wm3d/watermark/alignment.hpp>
#include <wm3d/watermark/examination.hpp>
#include <wm3d/watermark/search_suspect.hpp>

namespace wm3d::watermark {

enum class Detector { whitened, paper };

/// Whether all poses are searched where a quick look in a few finds nothing.
enum class SearchUse {
    never,
    when_needed, ///< the suspect could be a part of something, a scene, or a shape whose axes are unclear
    always,      ///< and with deformations undone
};

struct VerifyOptions {
    double pf = default_pf;
    Detector detector = Detector::whitened;
    Resync resync = Resync::pca;
    const resync::Receipt* receipt = nullptr;  ///< its frame is tried as it stands
    bool align_receipt = false;                ///< and as registration against its template finds it
    const TriangleMesh* reference = nullptr;   ///< align with it and look at the difference too
    SearchUse search = SearchUse::when_needed; ///< with the whitened detector and Resync::pca only
    double effort = 1;                         ///< of the search, see SearchEffort
    bool look_closer = true;  ///< at all vertices, where that shows more: see closer_look.hpp
    bool read_payload = true; ///< by the whitened detector, if there is one
    std::size_t vertices = default_vertices;
    std::size_t null_keys = 0;   ///< random keys to score on the same mesh
    std::uint64_t null_seed = 1; ///< which random keys
};

/// The paper's detector on this suspect, in the pose and at the level that serve it or the deciding detector
/// best.
struct PaperReport {
    detect::PaperStatistics statistics;
    double threshold = 0;     ///< eq. (6) at the verdict's P_f
    double log10_true_pf = 0; ///< what P_f that threshold truly has on this mesh, over random keys
    double log10_p = 0;       ///< exact, of this rho alone
};

/// What random keys score on the same mesh.
struct NullReport {
    std::size_t keys = 0;
    std::size_t false_positives = 0; ///< at the verdict's P_f, by the deciding detector
    double p_uniformity =
        1; ///< Kolmogorov-Smirnov: how likely the exact p of random keys stray as far from uniform
};

/// Why a verdict is inconclusive.
enum class Doubt {
    none,
    power,     ///< a mark of the usual strength would likely be missed here
    alignment, ///< a registration that was asked for failed: it was not looked at where the mark would lie
    opening,   ///< a part may have been cut off, and neither a search nor anything given told the pose
    vertices,  ///< the pose isn't known, and these are too few to search for it: TooFewVertices
    axes,      ///< the shape has no clear axes, and neither a search nor anything given told the pose
};

struct VerifyReport {
    detect::Verdict verdict = detect::Verdict::inconclusive;
    Doubt doubt = Doubt::none; ///< other than none just where the verdict is inconclusive
    double largest_opening =
        0;                    ///< area that would close the suspect's widest border, relative to its surface
    double lone_flat = 0;     ///< area of a plane face where a cut may have been closed, likewise; 0: none
    bool may_be_part = false; ///< an opening or such a face is so wide that a part may have been cut off
    detect::FamilyScore score;
    unsigned level = 0; ///< of the best hypothesis
    /// What the suspect says about each number of the level, as content_statistic: for payloads and recipients.
    detect::LinearStatistic statistic{{}, 1};
    std::size_t pose = 0;
    std::string pose_origin;
    /// Of that pose, in the suspect's coordinates; none where the mark is on a piece or deformed.
    std::optional<Frame> frame;
    std::optional<detect::Filter> filter; ///< none with the paper's detector and where the reference decided
    bool by_difference = false;           ///< the difference from the reference decided
    double reference_coverage = 0;        ///< part of the reference that has a counterpart in the suspect
    std::optional<resync::Registration> registration;
    std::optional<SearchReport> search; ///< where one was made; its pose is there where it decided
    std::size_t base_vertices = 0;
    double expected_sigmas = 0; ///< of a mark of the key's reference strength
    double predicted_miss = 1;
    PaperReport paper;
    std::optional<payload::Reading> payload; ///< where the whitened detector reads one, at `pf` or better
    std::optional<NullReport> null;
};

/// Whether the key's mark is in the suspect. The verdict isn't "absent" where a registration that was asked
/// for fails, nor where none was asked for and the suspect looks like a part of something: then its own axes
/// aren't the mark's.
/// \throw GeometryError if the mesh has no area
/// \throw ParameterError if the receipt belongs to another key, or this build can't register
VerifyReport verify(const TriangleMesh& suspect, const key::Key& key, const VerifyOptions& options = {},
                    const Progress& progress = {});

/// The same for a suspect that was prepared, its base mesh of `options.vertices`.
VerifyReport verify(const Suspect& suspect, const key::Key& key, const VerifyOptions& options = {},
                    const Progress& progress = {});

} // namespace wm3d::watermark
