// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  What `analyze` found, as tables, JSON, a plot and a page.
#pragma once

#include <string>
#include <vector>

#include <nlohmann/json_fwd.hpp>

#include <wm3d/report.hpp>
#include <wm3d/study/mesh_analysis.hpp>
#include <wm3d/study/roc.hpp>

namespace wm3d::cmd {

struct AnalysisReport {
    std::string title;
    std::vector<study::MeshStatistics> mesh; ///< one per number of vertices; none without a mesh
    std::vector<study::RocCurve> predicted;
    std::vector<study::MeasuredCurve> measured;
};

/// For people: without a mesh one table of all curves, with a mesh one for each strength and number of
/// vertices.
struct RocTable {
    std::string heading; ///< may be empty
    report::Table table; ///< one row per P_f, one column per curve
};
std::vector<RocTable> roc_tables(const AnalysisReport& report);

/// One row per number of vertices.
report::Table mesh_table(const AnalysisReport& report);

/// One row per point of every curve, in full precision: for programs.
report::Table long_table(const AnalysisReport& report);

/// Adds "mesh" (if there is one), "predicted" and "measured" (if there were trials) to `object`.
void add_json(nlohmann::ordered_json& object, const AnalysisReport& report);

report::Plot roc_plot(const AnalysisReport& report);

/// A page with the plot, the tables and `json` in full.
std::string roc_page(const AnalysisReport& report, const std::string& json);

} // namespace wm3d::cmd
