// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Simplification by half-edge collapse in the order of the Garland-Heckbert quadric error: the coarse
/// mesh whose vertices carry the mark.
#pragma once

#include <wm3d/simplify/observer.hpp>
#include <wm3d/simplify/simplify.hpp>
