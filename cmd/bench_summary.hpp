// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  A bench's results as people and programs read them.
#pragma once

#include <string>
#include <vector>

#include <wm3d/study/bench_cells.hpp>

namespace wm3d::cmd {

struct BenchSummary {
    std::vector<study::BenchTable> tables; ///< one for each size of marks
    study::WrongKeys wrong;
    std::vector<std::string> unusable; ///< "FILE: why", of models that could not be read or marked
    std::vector<std::string> commands; ///< that make these results again
    std::string version;
    std::uint64_t seed = 1;
    std::size_t keys = 0; ///< of the model that has most
    std::string heat_map; ///< file of the picture, beside the summary; empty: none
};

/// The payloads of a table, counted.
struct PayloadCount {
    std::size_t bits = 0;      ///< of one
    std::size_t keys = 0;      ///< payloads that were looked for in attacked copies
    std::size_t read = 0;      ///< of them, decoded without error
    std::size_t wrong = 0;     ///< of them, decoded to another payload
    std::size_t published = 0; ///< cells (attacks by models) with a published rate
    std::size_t as_published =
        0; ///< of these, no worse before decoding and none wrong behind it where theirs is few
};

PayloadCount count_payloads(const study::BenchTable& table);

BenchSummary summarize(const study::BenchResults& results, const study::BenchSetting& setting,
                       const std::vector<double>& log10_targets);

/// As GitHub reads it.
std::string bench_markdown(const BenchSummary& summary);

/// A line for every item.
std::string bench_csv(const study::BenchResults& results);

} // namespace wm3d::cmd
