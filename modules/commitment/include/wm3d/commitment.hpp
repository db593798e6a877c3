// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Fixing a key and a receipt beforehand, for all to see and none to read.
#pragma once

#include <wm3d/commitment/commitment.hpp>
#include <wm3d/commitment/deposit.hpp>
