// SPDX-License-Identifier: GPL-3.0-or-later
#include <wm3d/payload/soft_binding.hpp>

#include <sodium.h>

namespace wm3d::payload {

namespace {

std::string bytes_of(const Message& message) {
    if (message.kind == Message::Kind::text)
        return message.value;
    const std::string digits = (message.value.size() % 2 ? "0" : "") + message.value;
    std::string bytes;
    for (std::size_t i = 0; i < digits.size(); i += 2)
        bytes += static_cast<char>(std::stoi(digits.substr(i, 2), nullptr, 16));
    return bytes;
}

} // namespace

std::string soft_binding_value(const Message& message) {
    const std::string bytes = bytes_of(message);
    std::string text(sodium_base64_encoded_len(bytes.size(), sodium_base64_VARIANT_ORIGINAL), '\0');
    sodium_bin2base64(text.data(), text.size(), reinterpret_cast<const unsigned char*>(bytes.data()),
                      bytes.size(), sodium_base64_VARIANT_ORIGINAL);
    text.pop_back(); // the zero at its end
    return text;
}

} // namespace wm3d::payload
