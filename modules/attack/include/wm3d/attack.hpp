// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  What happens to models on their way through the world, by name (`apply`) or as functions.
#pragma once

#include <wm3d/attack/apply.hpp>
#include <wm3d/attack/cropping.hpp>
#include <wm3d/attack/deformation.hpp>
#include <wm3d/attack/flips.hpp>
#include <wm3d/attack/order.hpp>
#include <wm3d/attack/perturbation.hpp>
#include <wm3d/attack/random.hpp>
#include <wm3d/attack/resampling.hpp>
#include <wm3d/attack/smoothing.hpp>
#include <wm3d/attack/spec.hpp>
