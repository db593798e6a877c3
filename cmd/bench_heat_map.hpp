// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  A bench's results as a picture.
#pragma once

#include <vector>

#include <wm3d/report/heat_map.hpp>
#include <wm3d/study/bench_cells.hpp>

namespace wm3d::cmd {

/// Attacks by models, one group of columns for each size of marks; the worst key of each. The darker, the
/// smaller p; what misses the target stands out.
report::HeatMap bench_heat_map(const std::vector<study::BenchTable>& tables);

} // namespace wm3d::cmd
