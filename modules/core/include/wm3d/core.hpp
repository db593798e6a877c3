// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  What everything else stands on: errors, progress, threads, files and text, short
/// hashes, SplitMix64, the version.
#pragma once

#include <wm3d/core/base64.hpp>
#include <wm3d/core/descriptor.hpp>
#include <wm3d/core/error.hpp>
#include <wm3d/core/filed.hpp>
#include <wm3d/core/fnv.hpp>
#include <wm3d/core/hex.hpp>
#include <wm3d/core/json_depth.hpp>
#include <wm3d/core/json_number.hpp>
#include <wm3d/core/memory.hpp>
#include <wm3d/core/parallel.hpp>
#include <wm3d/core/progress.hpp>
#include <wm3d/core/split_mix.hpp>
#include <wm3d/core/utf8.hpp>
#include <wm3d/core/version.hpp>
