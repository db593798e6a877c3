// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Present, absent or inconclusive.
#pragma once

#include <cstddef>
#include <string_view>

namespace wm3d::detect {

enum class Verdict { present, absent, inconclusive };

std::string_view name(Verdict verdict);

/// Standard deviations at which a normal score has this tail probability.
/// \pre  log10_p < 0
double normal_sigmas(double log10_p);

/// Standard deviations that a mark's score stays below in its own pose, but for `chance` of all keys, however strong the
/// mark is and whatever else the surface says: sqrt(n) + sqrt(2 log(1 / chance)) for a mesh of n vertices, as T is a sum
/// of n numbers of the key's, each times a number of the mesh's (docs/algorithm.md, section 10). Holds for statistics
/// that are not evened.
double most_sigmas(std::size_t vertices, double chance = 0.01);

/// Predicted probability, by a normal approximation, that a mark with this expected score is missed.
/// \param sigmas      expected score of the best hypothesis, in standard deviations of its null distribution
/// \param log10_pf    log10 of the false-positive probability of the verdict
/// \param hypotheses  number of hypotheses that share it
double predicted_miss(double sigmas, double log10_pf, std::size_t hypotheses);

/// Present if log10_p <= log10_pf. Otherwise absent, if a mark would be missed with at most this probability,
/// and inconclusive if not: then the suspect can't tell.
Verdict decide(double log10_p, double log10_pf, double predicted_miss, double tolerated_miss = 0.01);

} // namespace wm3d::detect
