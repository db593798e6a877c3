// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  A suspect searched for the mark in every pose, from the key alone.
#pragma once

#include <cstddef>
#include <memory>
#include <optional>

#include <wm3d/core/progress.hpp>
#include <wm3d/detect/family.hpp>
#include <wm3d/mesh/frame.hpp>
#include <wm3d/search/centres.hpp>
#include <wm3d/search/pose.hpp>
#include <wm3d/watermark/examination.hpp>

namespace wm3d::watermark {

/// The part of a verdict's false-positive probability that the search may use up; the quick look, which comes
/// first, has the rest. As it is so small, the quick look's p stays what it was to three decimals of log10.
inline constexpr double search_share = 1e-3;

/// log10 p of a quick look that leaves the search its share, whether that will be needed or not.
/// \param log10_p  of the look alone
double beside_search(double log10_p);

/// Whether a part may be missing: an opening of more than 0.6 % of the surface, or of more than 0.05 % where a
/// limb ends, or a plane face that may have closed it. Cuts by a plane that remove 2 % of a closed model leave the one or the other; the largest hole
/// under the base of a scan such as the Stanford bunny has 0.5 %, and its rim is flat.
bool may_be_part(const search::Outline& outline);

struct SearchEffort {
    /// 1 tries 6000 pairs of a centre and a sequence on a suspect that may be cut, in a minute or two on two
    /// cores; other efforts accordingly more or fewer.
    double effort = 1;
    /// Search many centres even of what has no opening. Else only of pieces that have one; and around a
    /// piece's own centre where its axes are unclear.
    bool asked = false;
    search::Deformation deformation = search::Deformation::none; ///< the largest to undo
};

/// Where the mark was found.
struct FoundPose {
    Frame frame; ///< in the suspect's coordinates; the axes' determinant is -1 for a mirror image
    search::Deformation deformation = search::Deformation::none;
    Mat3 stretch = Mat3::Zero();
    bool mirrored = false;
    std::optional<std::size_t> piece; ///< of a scene, the largest first
};

/// Why nothing was searched that would have been worth it: so few vertices show no mark that pays for a search.
struct TooFewVertices {
    std::size_t vertices = 0; ///< of the largest piece, once simplified
    double most_sigmas = 0; ///< which marks on them stay below, however strong, but for one key of a hundred
    double needed_sigmas = 0; ///< at the pose that a search ends at
};

struct SearchReport {
    std::size_t pieces = 0;  ///< of the suspect that were looked at, itself included
    std::size_t centres = 0; ///< pairs of a centre and a sequence
    double rotations = 0;    ///< that were tried, over all of them
    double seconds = 0;
    double log10_hypotheses = 0; ///< that the pose paid for
    double expected_sigmas = 0;  ///< of a mark of the usual strength in the coarsest step of the search
    double enough = 1;     ///< effort for any cut: 4 for each piece with an opening, or 1 where there is none
    bool complete = false; ///< that was spent
    std::optional<TooFewVertices> too_few; ///< in which case no centre was tried
    std::optional<FoundPose> pose;
};

/// log10 of what a pose pays for that a search of a suspect with so many pieces ended at: everywhere that it could have
/// ended, and the search's share of the false-positive probability.
double log10_search_price(search::Deformation deformation, std::size_t pieces = 1);

/// A pose that the exact statistic confirmed.
struct SearchHit {
    std::unique_ptr<Examination> examination; ///< in that pose alone
    detect::FamilyScore score;                ///< with everything paid for
};

struct SearchResult {
    SearchReport report;
    std::optional<SearchHit> hit;
};

/// Looks for the key's mark in the mirror image of the poses that were tried already, in the pieces of a
/// scene, and about many centres in all rotations; stops at the first pose whose p is at most 10^log10_pf.
/// \param seen  the suspect's examination in the poses that its own axes tell
SearchResult search_suspect(const Suspect& suspect, const Examination& seen, Sequences& sequences,
                            const SearchEffort& effort, double reference_strength, double log10_pf,
                            const Progress& progress = {});

} // namespace wm3d::watermark
