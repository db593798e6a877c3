// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  How far apart two meshes are.
#pragma once

#include <wm3d/metrics/compare.hpp>
#include <wm3d/metrics/heatmap.hpp>
#include <wm3d/metrics/msdm2.hpp>
#include <wm3d/metrics/msdm2_patches.hpp>
#include <wm3d/metrics/surface_distance.hpp>
#include <wm3d/metrics/surface_tree.hpp>
