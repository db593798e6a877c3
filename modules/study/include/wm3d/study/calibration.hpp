// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  How often random keys really pass a threshold on a mesh: the proof that p is what it says.
#pragma once

#include <string>
#include <vector>

#include <wm3d/watermark/examination.hpp>

namespace wm3d::study {

/// How often a statistic passed the thresholds for each probability.
struct TailCounts {
    std::string statistic;           ///< "whitened, t = ..." or "paper, eq. (6)"
    std::vector<double> expected_pf; ///< per probability: what the exact null says of that threshold
    std::vector<std::size_t> passed; ///< per probability: keys that passed
};

struct Calibration {
    std::size_t keys = 0;
    std::vector<double> pf; ///< nominal probabilities
    std::vector<TailCounts> counts;
};

/// Scores `keys` random keys of the family `seed` on an unmarked mesh, in pose 0 and at one level: each
/// filter of the whitened detector against its exact thresholds, and the paper's rho against T_rho of eq.
/// (6), computed with each key's own moments.
/// \pre  level is one of the examination's
Calibration calibrate(const watermark::Examination& suspect, unsigned level, std::size_t keys,
                      std::uint64_t seed, const std::vector<double>& pf = {1e-1, 1e-2, 1e-3, 1e-4, 1e-5});

} // namespace wm3d::study
