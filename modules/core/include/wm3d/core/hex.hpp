// SPDX-License-Identifier: GPL-3.0-or-later
/// \file  Bytes as hexadecimal digits.
#pragma once

#include <cstdint>
#include <span>
#include <string>

namespace wm3d {

/// Two lower-case digits a byte. Takes the same steps whatever the bytes are: some are secret.
std::string to_hex(std::span<const std::uint8_t> bytes);

} // namespace wm3d
