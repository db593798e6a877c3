// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  The vocabulary every module speaks: meshes, measures, the canonical frame.
#pragma once

#include <wm3d/mesh/centre.hpp>
#include <wm3d/mesh/curve_order.hpp>
#include <wm3d/mesh/frame.hpp>
#include <wm3d/mesh/measure.hpp>
#include <wm3d/mesh/neighbours.hpp>
#include <wm3d/mesh/sides.hpp>
#include <wm3d/mesh/topology.hpp>
#include <wm3d/mesh/triangle_mesh.hpp>
#include <wm3d/mesh/types.hpp>
#include <wm3d/mesh/umbrella.hpp>
#include <wm3d/mesh/weld.hpp>
