// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Meshes made by formula: test shapes, surfaces of solids, and the demonstration sample.
#pragma once

#include <wm3d/shapes/contour.hpp>
#include <wm3d/shapes/sample.hpp>
#include <wm3d/shapes/shapes.hpp>
#include <wm3d/shapes/turned.hpp>
