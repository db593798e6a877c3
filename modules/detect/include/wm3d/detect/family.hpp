// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Many hypotheses, one verdict: every pose, level and filter that is tried is paid for.
#pragma once

#include <cstddef>
#include <functional>
#include <memory>
#include <span>
#include <string>
#include <vector>

#include <wm3d/detect/linear_statistic.hpp>
#include <wm3d/mesh/types.hpp>

namespace wm3d::detect {

/// What a hypothesis reads the mark from.
enum class Source {
    vertices,  ///< the suspect, at its vertices
    cells,     ///< the suspect, around its vertices
    reference, ///< the suspect's difference from a reference
};

/// One way the mark could sit in the suspect, fixed before the key is looked at.
struct Hypothesis {
    LinearStatistic statistic;
    unsigned level = 0;     ///< level of the watermarking sphere whose sequence the statistic takes
    std::size_t pose = 0;   ///< which of the candidate poses
    std::size_t filter = 0; ///< which filter of the bank; a reference has none
    Source source = Source::vertices;
    /// Where the sphere was turned so that its vertices only changed places: coefficient j counts number (*turn)[j] of the
    /// sequence. None: number j. Turned hypotheses share their coefficients, and so their distribution.
    std::shared_ptr<const std::vector<Index>> turn = nullptr;
};

/// The statistic with its coefficients in the order of the sequence.
LinearStatistic own_statistic(const Hypothesis& hypothesis);

/// The keyed sequence of a level.
using SequenceOfLevel = std::function<std::span<const double>(unsigned level)>;

/// How one hypothesis does with a key.
struct Score {
    std::size_t hypothesis = 0;
    double value = 0;   ///< T
    double sigmas = 0;  ///< T over its standard deviation under random keys
    double log10_p = 0; ///< exact, of this hypothesis alone
};

/// The best of a family with a key.
struct FamilyScore {
    Score best;
    std::size_t hypotheses = 0; ///< number that was tried, each of them paid for
    /// log10 of min(1, hypotheses * smallest p): the probability, at most, that any of them scores like this
    /// for a random key (Bonferroni).
    double log10_p = 0;
    double relative_error = 0; ///< estimated, of the best hypothesis' p
    bool bound = false;        ///< p is a guaranteed upper bound, not an estimate
};

/// Scores every hypothesis with the key's sequences and the best few exactly. The p that is reported belongs
/// to a hypothesis that was really scored, so leaving others out can only make it larger.
/// \throw ParameterError if there is no hypothesis
FamilyScore score_family(std::span<const Hypothesis> family, const SequenceOfLevel& sequence);

/// For each hypothesis the T at which its p is pf / #family: a key is a (false) positive where any is
/// reached.
std::vector<double> family_thresholds(std::span<const Hypothesis> family, double pf);

/// Whether any hypothesis reaches its threshold.
bool reaches(std::span<const Hypothesis> family, std::span<const double> thresholds,
             const SequenceOfLevel& sequence);

} // namespace wm3d::detect
