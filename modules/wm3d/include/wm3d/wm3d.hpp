// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  All that a program needs to mark meshes and files and to look for marks in them.
#pragma once

#include <wm3d/core.hpp>
#include <wm3d/io.hpp>
#include <wm3d/key.hpp>
#include <wm3d/mesh.hpp>
#include <wm3d/watermark.hpp>

namespace wm3d {

using detect::Verdict;
using io::read;
using key::Key;

using watermark::mark;
using watermark::mark_file;
using watermark::Marked;
using watermark::MarkedFile;
using watermark::MarkFileOptions;
using watermark::MarkOptions;

using watermark::verify;
using watermark::VerifyOptions;
using watermark::VerifyReport;

} // namespace wm3d
