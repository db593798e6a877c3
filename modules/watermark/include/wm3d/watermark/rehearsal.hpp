// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  What a fresh mark will bear, tried before the copy leaves the house.
#pragma once

#include <string>
#include <vector>

#include <wm3d/watermark/mark.hpp>
#include <wm3d/watermark/sequences.hpp>
#include <wm3d/watermark/suspect.hpp>

namespace wm3d::watermark {

/// An everyday attack and what was left of the mark.
struct Rehearsed {
    std::string attack;
    double log10_p = 0; ///< of one hypothesis; see `paid_for`
};

/// Noise of 0.3 %, ten steps of smoothing, coordinates of 8 bits, and three vertices in four gone, each on
/// the base mesh of the marked one and in the pose of the mark. A rehearsal and not the attack itself: what
/// an attack does to the pose, and a smoothing of vertices that the base mesh lacks, is left out. Read by those
/// filters of verify's bank that such damage leaves the most to, so verify finds as much or more.
/// \param marked  with the base mesh that verify looks at
std::vector<Rehearsed> rehearse(const Suspect& marked, const Frame& frame, Sequences& sequences,
                                unsigned level, double rmax);

/// The same, family-wise: of as many hypotheses as verify tries.
std::vector<Rehearsed> paid_for(std::vector<Rehearsed> rehearsed, std::size_t hypotheses);

} // namespace wm3d::watermark
