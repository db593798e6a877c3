// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Base64 (RFC 4648, standard alphabet).
#pragma once

#include <optional>
#include <string>
#include <string_view>

namespace wm3d {

std::string to_base64(std::string_view bytes);
/// Nothing if `text` holds a character outside the alphabet or has a length that can't be.
std::optional<std::string> from_base64(std::string_view text);

} // namespace wm3d
