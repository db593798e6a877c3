// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/core/base64.hpp>

#include <array>
#include <cstdint>

namespace wm3d {

namespace {

constexpr std::string_view alphabet = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";

constexpr std::array<std::int8_t, 256> inverse_alphabet() {
    std::array<std::int8_t, 256> inverse{};
    inverse.fill(-1);
    for (std::size_t i = 0; i < alphabet.size(); ++i)
        inverse[static_cast<unsigned char>(alphabet[i])] = static_cast<std::int8_t>(i);
    return inverse;
}

constexpr std::array<std::int8_t, 256> inverse = inverse_alphabet();

std::uint32_t byte_at(std::string_view bytes, std::size_t i) {
    return i < bytes.size() ? static_cast<unsigned char>(bytes[i]) : 0;
}

} // namespace

std::string to_base64(std::string_view bytes) {
    std::string text;
    text.reserve((bytes.size() + 2) / 3 * 4);
    for (std::size_t i = 0; i < bytes.size(); i += 3) {
        const std::uint32_t group =
            byte_at(bytes, i) << 16 | byte_at(bytes, i + 1) << 8 | byte_at(bytes, i + 2);
        for (int k = 0; k < 4; ++k)
            text.push_back(alphabet[group >> (18 - 6 * k) & 63]);
    }
    for (std::size_t i = bytes.size(); i % 3 != 0; ++i)
        text[text.size() - (i - bytes.size()) - 1] = '=';
    return text;
}

std::optional<std::string> from_base64(std::string_view text) {
    for (int padding = 0; padding < 2 && text.ends_with('='); ++padding)
        text.remove_suffix(1);
    if (text.size() % 4 == 1)
        return std::nullopt;
    std::string bytes;
    bytes.reserve(text.size() / 4 * 3 + 2);
    std::uint32_t group = 0;
    int bits = 0;
    for (char c : text) {
        const std::int8_t value = inverse[static_cast<unsigned char>(c)];
        if (value < 0)
            return std::nullopt;
        group = group << 6 | static_cast<std::uint32_t>(value);
        bits += 6;
        if (bits >= 8) {
            bits -= 8;
            bytes.push_back(static_cast<char>(group >> bits & 255));
        }
    }
    return bytes;
}

} // namespace wm3d
