// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Marks on meshes, and verdicts about them.
#pragma once

#include <wm3d/watermark/alignment.hpp>
#include <wm3d/watermark/closer_look.hpp>
#include <wm3d/watermark/content_statistic.hpp>
#include <wm3d/watermark/defaults.hpp>
#include <wm3d/watermark/examination.hpp>
#include <wm3d/watermark/identify.hpp>
#include <wm3d/watermark/mark.hpp>
#include <wm3d/watermark/mark_file.hpp>
#include <wm3d/watermark/marker.hpp>
#include <wm3d/watermark/null_keys.hpp>
#include <wm3d/watermark/pieces.hpp>
#include <wm3d/watermark/receipt.hpp>
#include <wm3d/watermark/rehearsal.hpp>
#include <wm3d/watermark/search_suspect.hpp>
#include <wm3d/watermark/sequences.hpp>
#include <wm3d/watermark/suspect.hpp>
#include <wm3d/watermark/verify.hpp>
