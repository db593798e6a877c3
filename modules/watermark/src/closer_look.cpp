// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/watermark/closer_look.hpp>

#include <algorithm>
#include <cmath>

#include <wm3d/watermark/search_suspect.hpp>

namespace wm3d::watermark {

bool can_look_closer(const Suspect& suspect) {
    const std::size_t all = suspect.mesh.positions.size();
    return suspect.base.positions.size() < all && all <= most_examined;
}

bool is_close_call(const detect::FamilyScore& first, double log10_pf) {
    return first.log10_p > 2 * log10_pf;
}

Examination look_closer(const Suspect& suspect, const Examination& first) {
    ExaminationOptions options = first.options();
    options.vertices = most_examined;
    options.resync = Resync::icp; // no poses but these
    options.poses.clear();
    for (std::size_t pose = 0; pose < first.poses(); ++pose)
        options.poses.push_back(first.pose(pose));
    return {suspect.mesh, std::move(options)};
}

detect::FamilyScore one_of_two_looks(detect::FamilyScore score) {
    score.hypotheses *= 2;
    score.log10_p = std::min(0.0, score.log10_p + std::log10(2.0));
    return score;
}

detect::FamilyScore score_look(std::span<const detect::Hypothesis> family, Sequences& sequences, bool twice,
                               bool searched) {
    detect::FamilyScore score = detect::score_family(family, sequences.function());
    if (twice)
        score = one_of_two_looks(score);
    if (searched)
        score.log10_p = beside_search(score.log10_p);
    return score;
}

} // namespace wm3d::watermark
