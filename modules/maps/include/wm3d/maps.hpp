// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  MAPS: the base domain, the map of the original's vertices onto it, and the way back.
#pragma once

#include <wm3d/maps/base_domain.hpp>
#include <wm3d/maps/equations.hpp>
#include <wm3d/maps/inverse_map.hpp>
