// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/core/hex.hpp>

namespace wm3d {

namespace {

/// By arithmetic: a table would be read at a place that tells the number.
char digit(unsigned number) {
    const unsigned is_letter = (9 - number) >> 31; // the sign of the difference
    return static_cast<char>('0' + number + is_letter * ('a' - '9' - 1));
}

} // namespace

std::string to_hex(std::span<const std::uint8_t> bytes) {
    std::string text;
    text.reserve(2 * bytes.size());
    for (const std::uint8_t byte : bytes) {
        text += digit(byte >> 4);
        text += digit(byte & 15);
    }
    return text;
}

} // namespace wm3d
