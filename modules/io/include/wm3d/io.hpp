// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Mesh files: read into one analysis mesh, write back with only the coordinates changed, write anew.
#pragma once

#include <wm3d/io/encode.hpp>
#include <wm3d/io/file.hpp>
#include <wm3d/io/format.hpp>
#include <wm3d/io/model.hpp>
