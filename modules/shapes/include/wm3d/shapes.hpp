// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Meshes made by formula: test shapes and the demonstration sample.
#pragma once

#include <wm3d/shapes/shapes.hpp>
