// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Pictures of meshes.
#pragma once

#include <wm3d/picture/image.hpp>
#include <wm3d/picture/render.hpp>
