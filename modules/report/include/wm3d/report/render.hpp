// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Plots as images.
#pragma once

#include <string>

#include <wm3d/report/heat_map.hpp>
#include <wm3d/report/plot.hpp>

namespace wm3d::report {

enum class Image { svg, png };

/// Whether gnuplot is on PATH.
bool can_render();

/// The bytes of the image, drawn by gnuplot.
/// \throw Error           if gnuplot isn't there (the sentence names the package) or fails
/// \throw ParameterError  if the plot has no point that could be drawn
std::string render(const Plot& plot, Image image);

/// \throw Error, ParameterError  as for a plot
std::string render(const HeatMap& map, Image image);

} // namespace wm3d::report
