// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Whose copy it is: a keyed sequence of signs for every copy, and a suspect against millions of them.
#pragma once

#include <cstdint>
#include <span>
#include <string_view>
#include <vector>

#include <wm3d/core/progress.hpp>
#include <wm3d/detect/linear_statistic.hpp>
#include <wm3d/key/secret.hpp>

namespace wm3d::payload {

/// Which of the owner's sequences a copy takes: a public number of 64 bits, from what was copied (its
/// digest), for whom and on which level's sphere.
std::uint64_t copy_number(std::string_view work, std::string_view recipient, unsigned level);

/// The sequence of a copy, as high as one that is uniform in (-rmax, rmax): #sequence_length(level) numbers
/// of -rmax / sqrt(3) and rmax / sqrt(3).
std::vector<double> copy_sequence(const key::Secret& secret, unsigned level, double rmax,
                                  std::uint64_t number);

/// T of every copy's sequence on a suspect, in standard deviations over random signs. About 1.5 microseconds
/// per copy on one thread for level 5: signs come as bytes, and the sums of eight coefficients for each byte
/// from a table.
/// \param statistic  what the suspect says; chosen by anything but these streams, for example by how well the
///        owner's
///                   common part shows. Its law doesn't matter here.
/// \param numbers    of the copies, all of one level
std::vector<double> copy_scores(const key::Secret& secret, const detect::LinearStatistic& statistic,
                                std::span<const std::uint64_t> numbers, const Progress& progress = {});

/// A copy whose sequence shows.
struct Accusation {
    std::size_t copy = 0; ///< its place in the list
    double sigmas = 0;
    /// log10 of the probability, at most, that any copy of the list that had no part in the suspect scores
    /// like this: the exact tail over random signs times the size of the family.
    double log10_p = 0;
};

/// Every copy with log10_p <= log10_pf, the clearest first. Holds however the suspect was made from the other
/// copies: the signs of a copy that had no part in it are independent of it.
/// \param family  hypotheses that are paid for, at least #scores
std::vector<Accusation> accuse(const detect::LinearStatistic& statistic, std::span<const double> scores,
                               double log10_pf, std::size_t family);

} // namespace wm3d::payload
