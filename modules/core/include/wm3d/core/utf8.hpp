// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Checking text that people typed before it goes into files and reports.
#pragma once

#include <string_view>

namespace wm3d {

/// Whether the text is well-formed UTF-8 (RFC 3629: shortest forms, no surrogates, at most U+10FFFF).
bool is_utf8(std::string_view text);

/// Whether it is well-formed UTF-8 without control characters: what a terminal may be shown.
bool is_printable(std::string_view text);

} // namespace wm3d
