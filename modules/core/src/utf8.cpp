// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/core/utf8.hpp>

#include <algorithm>
#include <array>
#include <cstddef>
#include <cstdint>

namespace wm3d {

namespace {

/// Bytes of the character that starts with this byte; 0 if none does.
std::size_t length_of(unsigned char lead) {
    if (lead < 0x80)
        return 1;
    if (lead >> 5 == 0b110)
        return 2;
    if (lead >> 4 == 0b1110)
        return 3;
    return lead >> 3 == 0b11110 ? 4 : 0;
}

} // namespace

bool is_utf8(std::string_view text) {
    constexpr std::array<std::uint32_t, 5> smallest{0, 0, 0x80, 0x800, 0x10000}; // code point of each length
    while (!text.empty()) {
        const auto lead = static_cast<unsigned char>(text[0]);
        const std::size_t length = length_of(lead);
        if (length == 0 || length > text.size())
            return false;
        std::uint32_t code = length == 1 ? lead : lead & (0x7fu >> length);
        for (const char c : text.substr(1, length - 1)) {
            const auto byte = static_cast<unsigned char>(c);
            if (byte >> 6 != 0b10)
                return false;
            code = code << 6 | (byte & 0x3f);
        }
        if (code < smallest[length] || code > 0x10ffff || (code >= 0xd800 && code < 0xe000))
            return false;
        text.remove_prefix(length);
    }
    return true;
}

bool is_printable(std::string_view text) {
    const auto is_c1 = [&](std::size_t i) { // U+0080 to U+009F: the byte c2 and one below a0
        return static_cast<unsigned char>(text[i]) == 0xc2 && i + 1 < text.size() &&
               static_cast<unsigned char>(text[i + 1]) < 0xa0;
    };
    for (std::size_t i = 0; i < text.size(); ++i)
        if (static_cast<unsigned char>(text[i]) < 0x20 || text[i] == 0x7f || is_c1(i))
            return false;
    return is_utf8(text);
}

} // namespace wm3d
