// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/watermark/closer_look.hpp>

#include <algorithm>
#include <cmath>

namespace wm3d::watermark {

bool can_look_closer(const Suspect& suspect) {
    const std::size_t all = suspect.mesh.positions.size();
    return suspect.base.positions.size() < all && all <= most_examined;
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

} // namespace wm3d::watermark
