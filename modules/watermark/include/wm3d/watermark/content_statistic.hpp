// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  What a suspect says about what a mark says besides whose it is.
#pragma once

#include <span>

#include <wm3d/detect/family.hpp>

namespace wm3d::watermark {

/// The statistics of the pose and level in which the common part shows best, one for each filter, blended with the
/// weights that serve the common part best:
///
///     c = sum_f a_f c_f / |c_f|,  a = (G + ridge I)^-1 t,  G_fg = cos(c_f, c_g),  t_f = c_f . w / |c_f|
///
/// Messages and recipients ride on streams of their own, so c may follow w in any way: for them it is fixed, and no
/// hypothesis is paid for. On scans that gives 3 to 20 % more than the best filter alone.
/// \param best  which hypothesis of the family the common part shows in
/// \param w     the common part's sequence at its level
detect::LinearStatistic content_statistic(std::span<const detect::Hypothesis> family, std::size_t best,
                                          std::span<const double> w);

} // namespace wm3d::watermark
