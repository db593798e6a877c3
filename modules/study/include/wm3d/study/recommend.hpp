// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  How large a mark must be.
#pragma once

#include <string>
#include <vector>

#include <wm3d/study/damage.hpp>
#include <wm3d/study/response.hpp>

namespace wm3d::study {

struct Requirement {
    double pf = 1e-9;                 ///< of the verdict
    double pm = 1e-6;                 ///< at most, unharmed and after each damage
    std::vector<NamedDamage> survive; ///< each alone
    std::size_t pilots = 8;           ///< marks that are tried per size and damage
};

struct Outcome {
    std::string damage; ///< "none", or its name
    double log10_pm = 0;
};

struct Recommendation {
    bool reached = false; ///< whether some size meets the requirement
    Sizing sizing = Sizing::visibility;
    double size = 0;  ///< the smallest that does, in the setting's sizing; else the largest that was tried
    double gamma = 0; ///< of bumps that move as much, mean over the marks that were tried
    embed::Distortion distortion;  ///< that it costs, measured, % of the box's diagonal
    std::vector<Outcome> outcomes; ///< empty if no mark keeps to the largest size that was tried
};

/// By what marks of a profile are best sized: what is seen of them, where the profile hides.
Sizing best_sizing(watermark::Profile profile);

/// Size above which nobody would call a mark hidden, where the search ends, with its unit: "0.5" or "2 %".
std::string largest_size(Sizing sizing);

/// The smallest size that meets the requirement on this mesh, within 2 %: the least visible mark of the
/// default profile, or the least strength. Each step marks the mesh with random keys, damages, examines and
/// so measures what is left of the mark; P_m then follows as in `log10_miss`.
/// \throw GeometryError, ParameterError as TrialBench
Recommendation recommend(const TriangleMesh& mesh, const TrialSetting& setting,
                         const Requirement& requirement, const Progress& progress = {});

} // namespace wm3d::study
