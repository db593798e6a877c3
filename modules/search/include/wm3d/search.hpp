// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Looking for a key's sphere in every pose.
#pragma once

#include <wm3d/search/harmonics.hpp>
#include <wm3d/search/rotation_correlation.hpp>
