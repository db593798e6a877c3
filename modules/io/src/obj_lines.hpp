// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Lines of an OBJ file.
#pragma once

#include <string>
#include <string_view>

namespace wm3d::io {

/// The bytes with every backslash that continues a line, and that line's end, blanked: same offsets.
std::string join_continued_lines(std::string_view bytes);

} // namespace wm3d::io
