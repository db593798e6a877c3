// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/core/hex.hpp>

#include <charconv>

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

std::optional<std::string> from_hex(std::string_view digits) {
    if (digits.size() % 2 != 0)
        return std::nullopt;
    std::string bytes;
    bytes.reserve(digits.size() / 2);
    for (const char* at = digits.data(); bytes.size() < digits.size() / 2; at += 2) {
        unsigned char byte = 0; // without a sign, which from_chars would take
        if (std::from_chars(at, at + 2, byte, 16).ptr != at + 2)
            return std::nullopt;
        bytes += static_cast<char>(byte);
    }
    return bytes;
}

} // namespace wm3d
