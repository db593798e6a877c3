// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Bytes as hexadecimal digits, and back.
#pragma once

#include <cstdint>
#include <optional>
#include <span>
#include <string>
#include <string_view>

namespace wm3d {

/// Two lower-case digits a byte. Takes the same steps whatever the bytes are: some are secret.
std::string to_hex(std::span<const std::uint8_t> bytes);
/// The bytes of digits of either case, two a byte. Nothing if `digits` holds anything else or is of odd length.
/// Not for secrets.
std::optional<std::string> from_hex(std::string_view digits);

} // namespace wm3d
