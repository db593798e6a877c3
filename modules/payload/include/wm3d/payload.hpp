// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Everything of wm3d::payload.
#pragma once

#include <wm3d/payload/carrier.hpp>
#include <wm3d/payload/message.hpp>
#include <wm3d/payload/polar_code.hpp>
#include <wm3d/payload/reading.hpp>
#include <wm3d/payload/recipients.hpp>
#include <wm3d/payload/sequence.hpp>
#include <wm3d/payload/soft_binding.hpp>
#include <wm3d/payload/uncoded.hpp>
