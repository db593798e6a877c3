// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Trials of marks, curves, recommendations. The bench, which not every build has, is apart:
/// bench.hpp.
#pragma once

#include <wm3d/study/calibration.hpp>
#include <wm3d/study/damage.hpp>
#include <wm3d/study/json_lines.hpp>
#include <wm3d/study/mesh_analysis.hpp>
#include <wm3d/study/paper_roc.hpp>
#include <wm3d/study/recommend.hpp>
#include <wm3d/study/response.hpp>
#include <wm3d/study/roc.hpp>
#include <wm3d/study/trial_log.hpp>
#include <wm3d/study/trials.hpp>
