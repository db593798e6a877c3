// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  A second look at a suspect where the first, at fewer vertices, finds nothing, or just so.
#pragma once

#include <cstddef>
#include <span>

#include <wm3d/detect/family.hpp>
#include <wm3d/watermark/examination.hpp>
#include <wm3d/watermark/sequences.hpp>

namespace wm3d::watermark {

/// Suspects of more vertices are examined on a simplified copy alone: a closer look at them would take long,
/// and what spoils a mark of so many vertices hardly spoils it less on all of them.
inline constexpr std::size_t most_examined = 50'000;

/// Whether a closer look shows more: the first was at a copy with fewer vertices, and all are not too many.
/// Known before any key is looked at, so that the price of both looks can be fixed.
bool can_look_closer(const Suspect& suspect);

/// Whether the first look leaves the answer open: it found nothing at this P_f, or not at its square.
bool is_close_call(const detect::FamilyScore& first, double log10_pf);

/// The suspect on all of its vertices, in the poses of the first look.
/// \pre  can_look_closer(suspect)
Examination look_closer(const Suspect& suspect, const Examination& first);

/// The score of one of two looks with as many hypotheses each: both are paid for, made or not.
detect::FamilyScore one_of_two_looks(detect::FamilyScore score);

/// The score of a look, with what else is tried where nothing is found paid for, whether it will be needed or not.
/// \param twice     a look of two
/// \param searched  before a search
detect::FamilyScore score_look(std::span<const detect::Hypothesis> family, Sequences& sequences, bool twice,
                               bool searched);

} // namespace wm3d::watermark
