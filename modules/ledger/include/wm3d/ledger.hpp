// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Everything of wm3d::ledger.
#pragma once

#include <wm3d/ledger/ledger.hpp>
