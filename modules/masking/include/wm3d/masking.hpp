// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Marks that the eye doesn't find: carriers under a mask, limits of creases, and a budget of visibility.
#pragma once

#include <wm3d/masking/budget.hpp>
#include <wm3d/masking/carriers.hpp>
#include <wm3d/masking/creases.hpp>
#include <wm3d/masking/weighty_windows.hpp>
