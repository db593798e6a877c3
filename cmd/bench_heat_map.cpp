// SPDX-License-Identifier: GPL-3.0-or-later
#include "bench_heat_map.hpp"

#include <algorithm>
#include <cmath>

#include <fmt/format.h>

namespace wm3d::cmd {

namespace {

using namespace study;

/// log10 p of the darkest cells: three decades of decades, for few models reach more.
constexpr double darkest = -1000;

report::HeatCell heat_cell(const BenchCell& cell, double log10_target) {
    report::HeatCell result;
    if (cell.keys == 0) {
        result.text = cell.error.empty() ? "" : "none";
        return result;
    }
    result.empty = false;
    result.alarm = cell.missed > 0;
    const double shown = cell.worst_log10_p > -0.05 ? 0 : cell.worst_log10_p; // never "-0.0"
    result.text = fmt::format("{}{:.{}f}", result.alarm ? "\u00d7 " : "", shown, shown <= -99.95 ? 0 : 1);
    if (!result.alarm) // logarithmic: p of 10^-12 and 10^-24 differ more for people than 10^-212 and 10^-224
        result.shade = std::log(cell.worst_log10_p / log10_target) / std::log(darkest / log10_target);
    return result;
}

bool measured(const BenchTable& table, std::size_t attack) {
    return std::ranges::any_of(table.cells[attack],
                               [](const BenchCell& cell) { return cell.keys > 0 || !cell.error.empty(); });
}

} // namespace

report::HeatMap bench_heat_map(const std::vector<BenchTable>& tables) {
    report::HeatMap map;
    map.title = "log10 p of the worst key, blind, after a random similarity";
    map.legend = "orange, \u00d7: missed     blue: found, the darker the surer";
    const std::vector<std::string>& attacks = tables.front().attacks; // the same in all
    for (const BenchTable& table : tables)
        map.groups.push_back({fmt::format("{}, found at {:.4g}", size_text(table.size), table.log10_target),
                              model_headings(table.models),
                              {}});
    for (std::size_t a = 0; a < attacks.size(); ++a) {
        if (std::ranges::none_of(tables, [&](const BenchTable& table) { return measured(table, a); }))
            continue;
        map.rows.push_back(attacks[a]);
        for (std::size_t t = 0; t < tables.size(); ++t) {
            auto& row = map.groups[t].cells.emplace_back();
            for (const BenchCell& cell : tables[t].cells[a])
                row.push_back(heat_cell(cell, tables[t].log10_target));
        }
    }
    return map;
}

} // namespace wm3d::cmd
