// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Is the mark there? The paper's detector and the exactly calibrated one that decides.
#pragma once

#include <wm3d/detect/cell_samples.hpp>
#include <wm3d/detect/evidence.hpp>
#include <wm3d/detect/family.hpp>
#include <wm3d/detect/linear_statistic.hpp>
#include <wm3d/detect/normal_orthant.hpp>
#include <wm3d/detect/paper.hpp>
#include <wm3d/detect/paper_null.hpp>
#include <wm3d/detect/reference_evidence.hpp>
#include <wm3d/detect/surface_filter.hpp>
#include <wm3d/detect/tail.hpp>
#include <wm3d/detect/verdict.hpp>
