// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  From a pose near the right one to the best one around.
#pragma once

#include <span>

#include <wm3d/search/key_function.hpp>
#include <wm3d/search/pose.hpp>

namespace wm3d::search {

struct RefineOptions {
    int iterations = 60;
    double first_step = 0.005; ///< of the fastest parameter: radians, units of the suspect
    double least_gain = 1e-4;  ///< relative, below which it has arrived
};

struct Refined {
    Pose pose;
    double value = 0; ///< sum q_i w(direction of x_i)
    int iterations = 0;
    bool arrived = false; ///< gains had become small; else the iterations ran out
};

/// Climbs sum q_i w(direction of x_i) from a pose, with as many parameters as its deformation has, by the
/// method of Broyden, Fletcher, Goldfarb and Shanno. It follows the key, so the result is worth what the
/// lattice of poses costs.
/// \param x  #points, in the suspect's units
/// \param q  #points
Refined refine(std::span<const Vec3> x, std::span<const double> q, const KeyFunction& key, const Pose& start,
               const RefineOptions& options = {});

/// sum q_i w(direction of x_i).
double correlation(std::span<const Vec3> x, std::span<const double> q, const KeyFunction& key,
                   const Pose& pose);

} // namespace wm3d::search
