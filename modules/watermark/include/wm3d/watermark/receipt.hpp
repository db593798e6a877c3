// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  What `mark` tells the owner about finding a moved copy again: receipt and ambiguity.
#pragma once

#include <string_view>

#include <wm3d/resync/hierarchical_frame.hpp>
#include <wm3d/resync/receipt.hpp>
#include <wm3d/watermark/mark.hpp>

namespace wm3d::watermark {

/// The receipt of a marking; `original` and `marked_file` are the bytes of the two files.
resync::Receipt make_receipt(const TriangleMesh& mesh, const Marked& marked, const key::Key& key,
                             std::string_view original, std::string_view marked_file,
                             const Progress& progress = {});

} // namespace wm3d::watermark
