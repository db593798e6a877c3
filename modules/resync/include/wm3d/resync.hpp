// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Finding the frame of the mark on a copy that was moved, scaled or cut.
#pragma once

#include <wm3d/resync/candidate_pose.hpp>
#include <wm3d/resync/hierarchical_frame.hpp>
#include <wm3d/resync/pose_template.hpp>
#include <wm3d/resync/receipt.hpp>
#include <wm3d/resync/registration.hpp>
#include <wm3d/resync/similarity.hpp>
#include <wm3d/resync/smoothing_trend.hpp>
#include <wm3d/resync/surface_difference.hpp>
