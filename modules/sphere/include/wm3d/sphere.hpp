// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The watermarking sphere: subdivided icosahedron, point location, bumps.
#pragma once

#include <wm3d/sphere/bumped_sphere.hpp>
#include <wm3d/sphere/half_turns.hpp>
#include <wm3d/sphere/icosphere.hpp>
#include <wm3d/sphere/sparse_rows.hpp>
