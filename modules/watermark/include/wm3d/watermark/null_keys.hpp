// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Random keys on one mesh: the false-positive probability put to the test.
#pragma once

#include <span>
#include <vector>

#include <wm3d/watermark/verify.hpp>

namespace wm3d::watermark {

/// Scores `keys` random keys of the family `seed` on the hypotheses of a suspect. Uniformity is tested on the
/// p of the first hypothesis, for at most the first 2 000 keys (family-wise p are conservative and so not
/// uniform).
NullReport score_null_keys(std::span<const detect::Hypothesis> family, double rmax, double pf,
                           std::size_t keys, std::uint64_t seed, const Progress& progress = {});

/// Asymptotic Kolmogorov-Smirnov probability that n uniform numbers stray at least this far from uniform.
/// \param p  #n numbers of [0, 1], in any order
double uniformity(std::vector<double> p);

} // namespace wm3d::watermark
