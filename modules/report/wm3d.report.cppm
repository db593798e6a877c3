// SPDX-License-Identifier: GPL-3.0-or-later
// Written by scripts/interface-units from the public headers, which say what everything is.
module;
#include <wm3d/report.hpp>

export module wm3d.report;

export namespace wm3d::report {
using wm3d::report::can_render;
using wm3d::report::Curve;
using wm3d::report::gnuplot_script;
using wm3d::report::heat_map_size;
using wm3d::report::HeatCell;
using wm3d::report::HeatGroup;
using wm3d::report::HeatMap;
using wm3d::report::HeatSize;
using wm3d::report::html_escaped;
using wm3d::report::Image;
using wm3d::report::Page;
using wm3d::report::palette_size;
using wm3d::report::Plot;
using wm3d::report::PlotPoint;
using wm3d::report::render;
using wm3d::report::Section;
using wm3d::report::Table;
using wm3d::report::to_csv;
using wm3d::report::to_html;
using wm3d::report::to_markdown;
using wm3d::report::to_text;
} // namespace wm3d::report
