// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Results of a bench gathered into tables of attacks x models, the worst of all keys in each cell.
#pragma once

#include <string>
#include <vector>

#include <wm3d/study/bench.hpp>

namespace wm3d::study {

/// What all keys of one attack on one model have in common.
struct BenchCell {
    std::size_t keys = 0;      ///< that were examined
    std::size_t missed = 0;    ///< of them, with p above the target
    double worst_log10_p = 0;  ///< largest over the keys
    std::size_t worst_key = 0; ///< which has it
    std::string error;         ///< why there is no copy to examine; else empty
};

/// What became of the payloads of all keys of one attack on one model.
struct PayloadCell {
    std::size_t keys = 0;          ///< that were examined
    std::size_t bits = 0;          ///< of one payload
    std::size_t raw_errors = 0;    ///< of all keys together, without a code
    std::size_t worst_errors = 0;  ///< of one key
    std::size_t read = 0;          ///< keys whose payload was decoded without error
    std::size_t wrong = 0;         ///< keys that gave another payload than was sent
    double worst_log10_p = -1e300; ///< largest over the keys

    double mean_rate() const; ///< of errors without a code, over all keys; 0 if there are none
    double worst_rate() const;
};

/// How large the marks of one model became, over its keys.
struct BenchMarkRow {
    std::string model;
    std::size_t vertices = 0;
    std::size_t keys = 0;
    double mean_strength = 0, mean_mrms = 0, largest_mrms = 0, mean_msdm2 = 0, largest_msdm2 = 0;
    double mean_msdm2_both = 0; ///< NaN where a mark of the log lacks it
};

/// All marks of one size.
struct BenchTable {
    MarkSize size;
    double log10_target = -9;                  ///< p that is to be reached
    std::vector<std::string> models;           ///< files, in the order of their names
    std::vector<std::string> attacks;          ///< in the order of the published benchmark, others behind it
    std::vector<std::vector<BenchCell>> cells; ///< #attacks by #models
    std::vector<std::vector<BenchCell>>
        assisted; ///< the same with the original at hand; empty if not asked for
    std::vector<std::vector<PayloadCell>> payloads; ///< #attacks by #models; empty if no mark carries one
    std::vector<BenchMarkRow> marks;

    std::size_t filled() const; ///< cells with at least one key
    std::size_t missed() const; ///< of them, those with a miss
};

/// How often wrong keys scored at least as well as a probability says, on all attacked copies together.
struct WrongKeyCount {
    double pf = 0;
    std::size_t family = 0;   ///< keys whose family-wise p is at most pf
    double family_excess = 1; ///< probability of so many or more if each had probability pf
    std::size_t one = 0;      ///< keys whose p in one hypothesis is at most pf
    double one_strays = 1;    ///< two-sided probability of a number so far from the expected
};

struct WrongKeys {
    std::size_t keys = 0;
    std::vector<WrongKeyCount> counts; ///< at 0.1, 0.01, 0.001
    double smallest_log10_p = 0;       ///< family-wise
    double uniformity =
        1; ///< Kolmogorov-Smirnov: how likely uniform p stray as far as those in one hypothesis
};

BenchTable bench_table(const BenchResults& results, const MarkSize& size, double log10_target);

/// "MRMS up to 0.02 %", "MSDM2 up to 0.1" or "strength 0.019 %".
std::string size_text(const MarkSize& size);

/// Names of the models for headings: without the extension where that leaves them different.
std::vector<std::string> model_headings(const std::vector<std::string>& files);

WrongKeys count_wrong_keys(const BenchResults& results);

} // namespace wm3d::study
