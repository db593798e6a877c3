// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  How strong a mark must be.
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
    std::size_t pilots = 8;           ///< marks that are tried per strength and damage
};

struct Outcome {
    std::string damage; ///< "none", or its name
    double log10_pm = 0;
};

struct Recommendation {
    bool reached = false; ///< whether some strength meets the requirement
    double strength = 0; ///< the smallest that does, % of the box's diagonal; else the largest that was tried
    double gamma = 0;    ///< of eq. (3), mean over the marks that were tried
    embed::Distortion distortion; ///< that it costs, measured, % of the box's diagonal
    std::vector<Outcome> outcomes;
};

/// Strength above which nobody would call a mark hidden, % of the box's diagonal: the search ends there.
inline constexpr double largest_strength = 2;

/// The smallest strength that meets the requirement on this mesh, within 2 %. Each step marks the mesh with
/// random keys, damages, examines and so measures what is left of the mark; P_m then follows as in
/// `log10_miss`.
/// \throw GeometryError, ParameterError as TrialBench
Recommendation recommend(const TriangleMesh& mesh, const TrialSetting& setting,
                         const Requirement& requirement, const Progress& progress = {});

} // namespace wm3d::study
