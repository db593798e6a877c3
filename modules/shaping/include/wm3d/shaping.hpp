// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Marks shaped for the detector.
#pragma once

#include <wm3d/shaping/shaping.hpp>
