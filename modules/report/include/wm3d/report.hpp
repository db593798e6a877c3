// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Tables, plots and pages.
#pragma once

#include <wm3d/report/heat_map.hpp>
#include <wm3d/report/html.hpp>
#include <wm3d/report/plot.hpp>
#include <wm3d/report/render.hpp>
#include <wm3d/report/table.hpp>
