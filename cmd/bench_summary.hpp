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

BenchSummary summarize(const study::BenchResults& results, const study::BenchSetting& setting,
                       const std::vector<double>& log10_targets);

/// As GitHub reads it.
std::string bench_markdown(const BenchSummary& summary);

/// A line for every item.
std::string bench_csv(const study::BenchResults& results);

} // namespace wm3d::cmd
