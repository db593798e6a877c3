// SPDX-License-Identifier: GPL-3.0-or-later
#pragma once

#include <array>
#include <numeric>
#include <string>

#include <wm3d/key/secret.hpp>

/// The secret of the frozen vectors: bytes 0, 1, ..., 31.
inline wm3d::key::Secret fixed_secret() {
    std::array<std::uint8_t, wm3d::key::Secret::size> bytes;
    std::iota(bytes.begin(), bytes.end(), std::uint8_t{0});
    return wm3d::key::Secret(bytes);
}

inline std::string hex(std::span<const std::uint8_t> bytes) {
    std::string text;
    for (const std::uint8_t byte : bytes) {
        text += "0123456789abcdef"[byte / 16];
        text += "0123456789abcdef"[byte % 16];
    }
    return text;
}
