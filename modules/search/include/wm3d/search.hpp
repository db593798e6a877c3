// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Looking for a key's sphere in every pose.
#pragma once

#include <wm3d/search/centres.hpp>
#include <wm3d/search/flats.hpp>
#include <wm3d/search/harmonics.hpp>
#include <wm3d/search/key_function.hpp>
#include <wm3d/search/pose.hpp>
#include <wm3d/search/pose_search.hpp>
#include <wm3d/search/refine.hpp>
#include <wm3d/search/rotation_correlation.hpp>
